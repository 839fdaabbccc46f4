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

    /// Sets the tip-over assessment of the next measurement: pitch and roll read "STEEP", amber, or "DANGER", red.
    void setAttitude(const Attitude& attitude) { attitude_ = attitude; }

    /// Shows one telemetry sample. age: [s]. captured: pitch of the drawn scene [rad]; empty: the measurement itself is
    /// drawn.
    void setMeasurement(const Measurement& measurement, double age,
                        std::optional<double> captured = {});
    /// Shows a sample whose values arrive in separate messages. ages: per value; an old value is stale.
    void setMeasurement(const Measurement& measurement, double age, const Ages& ages,
                        std::optional<double> captured = {});
    /// Shows or hides pitch and roll, which another part of the page may show.
    void showAttitude(bool shown);
    void clearMeasurement();  ///< nothing was received yet

    QString text(int row) const;  ///< shown text; rows in the order of Row
    QString ageText(int row) const;

private:
    void show(Row row, const QString& text, bool known);
    void showAngle(Row row, double angle, AttitudeLevel level);

    std::array<QLabel*, kRows> names_{}, values_{};
    std::array<QString, kRows> ages_;
    Attitude attitude_;
};

}  // namespace terratact
