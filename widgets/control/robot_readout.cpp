#include "widgets/control/robot_readout.h"

#include <QGridLayout>
#include <QLabel>
#include <cmath>
#include <limits>
#include <optional>

#include "app/display/format.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {

namespace {

constexpr int kColumnGap = 14;  // [px]

}  // namespace

RobotReadout::RobotReadout(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Robot"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kColumnGap);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    const std::array<QString, kRows> names{tr("pitch"),          tr("roll"),
                                           tr("front flippers"), tr("rear flippers"),
                                           tr("front currents"), tr("rear currents")};
    for (int row = 0; row < kRows; ++row) {
        const auto i = static_cast<std::size_t>(row);
        names_[i] = new PlainLabel(names[i], this);
        setTone(*names_[i], Tone::Muted);
        values_[i] = new PlainLabel(this);
        values_[i]->setAccessibleName(names[i]);
        grid->addWidget(names_[i], row, 0);
        grid->addWidget(values_[i], row, 1);
    }
    grid->setRowStretch(kRows, 1);
    clearMeasurement();
}

void RobotReadout::show(Row row, const QString& text, bool known)
{
    QLabel* label = values_[row];
    label->setText(text);
    setTone(*label, known ? Tone::Strong : Tone::Muted);
}

void RobotReadout::showAngle(Row row, double angle, AttitudeLevel level)
{
    const QString value = format::angle(angle);
    if (level == AttitudeLevel::Level) return show(row, value, true);
    const bool isRed = level == AttitudeLevel::Red;
    values_[row]->setText(isRed ? tr("%1 DANGER").arg(value) : tr("%1 STEEP").arg(value));
    setTone(*values_[row], isRed ? Tone::Bad : Tone::Warning);
}

void RobotReadout::setMeasurement(const Measurement& m, double age, std::optional<double> captured)
{
    Ages same{};
    same.fill(age);
    setMeasurement(m, age, same, captured);
}

void RobotReadout::setMeasurement(const Measurement& m, double age, const Ages& ages,
                                  std::optional<double> captured)
{
    const bool fresh = age <= kStaleAfter;
    const auto put = [&](Row row, const QString& text) {
        if (fresh) return show(row, text, true);
        const QString old = tr("%1 old").arg(format::age(ages[row]));
        const bool isKnown = std::isfinite(ages[row]);
        show(row, isKnown ? QStringLiteral("%1   %2").arg(format::kNothing, old) : format::kNothing,
             false);
    };
    const auto pair = [](const QString& left, const QString& right) {
        return RobotReadout::tr("L %1   R %2").arg(left, right);
    };
    const auto amperes = [](const std::optional<double>& current) {
        const double value = current.value_or(std::numeric_limits<double>::quiet_NaN());
        return format::signedNumber(value, 2) + QStringLiteral(" A");
    };
    fresh ? showAngle(Pitch, m.pitch, attitude_.pitch) : put(Pitch, {});
    // Two samples always differ by sensor noise.
    if (captured)
        values_[Pitch]->setText(tr("%1   captured %2").arg(text(Pitch), format::angle(*captured)));
    fresh ? showAngle(Roll, m.roll, attitude_.roll) : put(Roll, {});
    const auto angles = [&](double left, double right) {
        // The unit of radians appears once: two do not fit in a low window.
        return pair(format::angle(left).section(QLatin1Char(' '), 0, 0), format::angle(right));
    };
    put(FrontFlippers, angles(m.frontLeft, m.frontRight));
    put(RearFlippers, angles(m.rearLeft, m.rearRight));
    const MotorCurrents currents = motorCurrents(m);
    put(FrontCurrents, pair(amperes(currents[0]), amperes(currents[1])));
    put(RearCurrents, pair(amperes(currents[2]), amperes(currents[3])));
    for (std::size_t row = 0; row < ages.size(); ++row) {
        ages_[row] = format::age(ages[row]);
        QString tip = tr("%1 old").arg(ages_[row]);
        if (row == Pitch && captured)
            tip += tr("; beside it the value of the captured scene, at which the robot is drawn");
        setTip(*values_[row], tip);
    }
}

void RobotReadout::showAttitude(bool shown)
{
    for (const Row row : {Pitch, Roll})
        for (QLabel* const label : {names_[row], values_[row]}) label->setVisible(shown);
}

void RobotReadout::clearMeasurement()
{
    for (std::size_t row = 0; row < values_.size(); ++row) {
        show(static_cast<Row>(row), format::kNothing, false);
        ages_[row].clear();
        setTip(*values_[row], {});
    }
}

QString RobotReadout::ageText(int row) const
{
    return ages_.at(static_cast<std::size_t>(row));
}

QString RobotReadout::text(int row) const
{
    return values_.at(static_cast<std::size_t>(row))->text();
}

}  // namespace terratact
