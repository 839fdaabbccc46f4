#pragma once

#include <array>

#include "core/robot/measurement.h"
#include "widgets/card.h"

class QGridLayout;
class QLabel;

namespace terratact {

/// Older telemetry than this is not shown as if it were true [s].
inline constexpr double kStaleAfter = 0.15;

/// The robot's angles and currents L left, R right.  A value older than kStaleAfter reads "--".
class RobotReadout final : public QWidget {
    Q_OBJECT
public:
    explicit RobotReadout(QWidget* parent = nullptr);

    void setMeasurement(const Measurement& measurement, double ageSeconds);
    void clearMeasurement();  ///< nothing has arrived yet

    QString text(int row) const;  ///< value as shown; rows as in the order of Row
    enum Row { Pitch, Roll, FrontFlippers, RearFlippers, FrontCurrents, RearCurrents, kRows };

private:
    void show(Row row, const QString& text, bool known);

    std::array<QLabel*, kRows> values_{};
};

}  // namespace terratact
