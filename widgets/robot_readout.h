#pragma once

#include <array>
#include <optional>

#include "core/robot/measurement.h"
#include "widgets/card.h"

class QGridLayout;
class QLabel;

namespace terratact {

/// Older telemetry than this is not shown as if it were true [s].
inline constexpr double kStaleAfter = 0.15;

/// The robot's angles and currents L left, R right.  A value older than kStaleAfter reads "--".  Beside the pitch
/// stands that of the scene which is drawn.
class RobotReadout final : public QWidget {
    Q_OBJECT
public:
    explicit RobotReadout(QWidget* parent = nullptr);

    /// captured: pitch of the scene that is drawn [rad]; empty: what is drawn is the measurement.
    void setMeasurement(const Measurement& measurement, double ageSeconds,
                        std::optional<double> captured = {});
    void clearMeasurement();  ///< nothing has arrived yet

    QString text(int row) const;  ///< value as shown; rows as in the order of Row
    enum Row { Pitch, Roll, FrontFlippers, RearFlippers, FrontCurrents, RearCurrents, kRows };

private:
    void show(Row row, const QString& text, bool known);

    std::array<QLabel*, kRows> values_{};
};

}  // namespace terratact
