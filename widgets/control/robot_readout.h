#pragma once

#include <array>
#include <optional>

#include "core/limits.h"
#include "core/robot/attitude.h"
#include "core/robot/measurement.h"
#include "widgets/base/card.h"

class QGridLayout;
class QLabel;

namespace terratact {

/// Angles and currents of the robot, left (L) and right (R); the tip of each shows its age. A value older than
/// kStaleAfter reads "--" with its age. The pitch of the drawn scene stands beside the current pitch.
class RobotReadout final : public QWidget {
    Q_OBJECT
public:
    explicit RobotReadout(QWidget* parent = nullptr);

    enum Row { Pitch, Roll, FrontFlippers, RearFlippers, FrontCurrents, RearCurrents, kRows };
    using Ages = std::array<double, kRows>;  ///< [s]; not finite: never received

    /// Of the measurement that is set next: pitch and roll read "STEEP", amber, or "DANGER", red.
    void setAttitude(const Attitude& attitude) { attitude_ = attitude; }

    /// Values of one line of telemetry, which is of `age` [s] ago.  captured: pitch of the scene that is drawn [rad];
    /// empty: what is drawn is the measurement.
    void setMeasurement(const Measurement& measurement, double age,
                        std::optional<double> captured = {});
    /// The values may arrive in messages of their own, which say of each whether it still comes.
    void setMeasurement(const Measurement& measurement, double age, const Ages& ages,
                        std::optional<double> captured = {});
    void clearMeasurement();  ///< nothing has arrived yet

    QString text(int row) const;  ///< as shown; rows as in the order of Row
    QString ageText(int row) const;

private:
    void show(Row row, const QString& text, bool known);
    void showAngle(Row row, double angle, AttitudeLevel level);

    std::array<QLabel*, kRows> values_{};
    std::array<QString, kRows> ages_;
    Attitude attitude_;
};

}  // namespace terratact
