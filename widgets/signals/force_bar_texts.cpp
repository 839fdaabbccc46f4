#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "app/display/format.h"
#include "core/robot/force_drift.h"
#include "widgets/signals/force_bars.h"
#include "widgets/signals/force_chart.h"

// Numbers, marks and spoken texts of the elements.

namespace terratact {
namespace {

constexpr double kLabelGap = 6.0;  // [px] gap between the labels of two elements

}  // namespace

QString ForceBars::unitText() const
{
    return unit_ == Unit::Newtons ? QStringLiteral("N") : QStringLiteral("V");
}

QString ForceBars::legend() const
{
    if (arrays() < 2 && arrays_[0].name.isEmpty()) return {};
    QStringList names;
    for (std::size_t a = 0; a < arrays_.size(); ++a)
        names << QChar(arrayLook(a).symbol) + QLatin1Char(' ') + arrays_[a].name;
    return names.join(QStringLiteral("  "));
}

QString ForceBars::numberText(int element, int array) const
{
    const auto value = shown(element, array);
    if (!value) return format::kNothing;
    if (unit_ == Unit::Volts) return format::number(*value, 2);
    if (at(element, array).saturated)
        return QLatin1Char('>') + format::number(std::floor(*value), 0);
    const bool isLarge =
        arraysWith(element).size() > 1 && *value >= 9.95;  // two numbers share the width
    return format::number(*value, isLarge ? 0 : 1);
}

QString ForceBars::driftText(int element) const
{
    double largest = 0.0;
    for (int a = 0; a < arrays(); ++a) {
        const double drift = at(element, a).drift.value_or(0.0);
        if (std::abs(drift) > std::abs(largest)) largest = drift;
    }
    if (!(std::abs(largest) > ForceDrift::kNotable)) return {};
    return tr("bias %1 N").arg(format::signedNumber(largest, 1));
}

/// Returns the number of text lines above a bar, without the word "contact", so that bars keep some height.
int ForceBars::labelRows() const
{
    constexpr double kShare = 0.7;  // share of the canvas height
    const double line = QFontMetricsF(labelFont(true)).height();
    return std::max(1, static_cast<int>(kShare * canvas()->height() / line) - 1);
}

QString ForceBars::labelText(int element) const
{
    QStringList numbers;
    bool saturated = false;
    for (const int a : arraysWith(element)) {
        numbers << numberText(element, a);
        saturated = saturated || at(element, a).saturated;
    }
    const QFontMetricsF metrics(labelFont(touching(element)));
    const QString row = numbers.join(QStringLiteral("  "));
    const auto fits = [&](const QString& line) {
        return metrics.horizontalAdvance(line) + kLabelGap <= groupWidth();
    };
    QString text = fits(row) ? row : numbers.join(QLatin1Char('\n'));
    const QString mark = tr("▲ sat.");
    if (saturated) text += QLatin1Char('\n') + (fits(mark) ? mark : mark.left(1));
    if (text.count(QLatin1Char('\n')) < labelRows()) return text;
    // A low chart shows only the largest number; that of a saturated element is a lower bound. The tip lists all
    // numbers.
    const std::vector<int> with = arraysWith(element);
    const int largest = *std::ranges::max_element(with, {}, [&](int a) {
        return std::pair(at(element, a).saturated, shown(element, a).value_or(-1.0));
    });
    text = numberText(element, largest);
    const QString marked = text + QLatin1Char(' ') + mark.left(1);
    return saturated && fits(marked) ? marked : text;
}

QString ForceBars::spoken(int element) const
{
    QStringList parts;
    for (const int a : arraysWith(element)) {
        const QString& name = arrays_[static_cast<std::size_t>(a)].name;
        QString text = numberText(element, a) + QLatin1Char(' ') + unitText();
        if (!name.isEmpty()) text.prepend(name + QLatin1Char(' '));
        if (at(element, a).saturated) text += QLatin1Char(' ') + tr("saturated");
        parts << text;
    }
    if (touching(element)) parts << tr("contact");
    if (const QString drift = driftText(element); !drift.isEmpty()) parts << drift;
    return tr("element %1: %2").arg(element + 1).arg(parts.join(QStringLiteral(", ")));
}

}  // namespace terratact
