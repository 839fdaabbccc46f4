#include "widgets/base/target_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOptionMenuItem>
#include <QStyleOptionSpinBox>
#include <algorithm>

#include "widgets/base/palette.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

int target()
{
    return std::max(kTarget, scaled(kTarget));
}

/// Draws a frame that is visible on a card in every theme.
void drawFrame(QPainter& painter, const QRect& around)
{
    painter.save();
    painter.setPen(theme().muted);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(around.adjusted(0, 0, -1, -1));
    painter.restore();
}

bool hasArrows(const QStyleOption* option)
{
    const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
    return box && box->buttonSymbols != QAbstractSpinBox::NoButtons;
}

}  // namespace

TargetStyle::TargetStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

QRect TargetStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                  SubControl part, const QWidget* widget) const
{
    const QRect usual = QProxyStyle::subControlRect(control, option, part, widget);
    if (control != CC_SpinBox || !hasArrows(option)) return usual;
    const QRect all = option->rect;
    const auto place = [&](int left, int width) {
        return visualRect(option->direction, all, {left, all.top(), width, all.height()});
    };
    const int up = all.right() + 1 - target(), down = up - target();
    switch (part) {
    case SC_SpinBoxUp: return place(up, target());
    case SC_SpinBoxDown: return place(down, target());
    case SC_SpinBoxEditField: {
        const QRect inside = visualRect(option->direction, all, usual);
        return visualRect(option->direction, all,
                          {inside.left(), inside.top(), down - inside.left(), inside.height()});
    }
    default: return usual;
    }
}

void TargetStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                     QPainter* painter, const QWidget* widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_SpinBox || control == CC_ComboBox) drawFrame(*painter, option->rect);
}

void TargetStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const
{
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_IndicatorCheckBox) drawFrame(*painter, option->rect);
}

int TargetStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                             const QWidget* widget) const
{
    // The focus frame lies on the control's edge.
    if (metric == PM_FocusFrameHMargin || metric == PM_FocusFrameVMargin) return 0;
    return QProxyStyle::pixelMetric(metric, option, widget);
}

int TargetStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* more) const
{
    if (hint == SH_FocusFrame_Mask) return 0;
    if (hint == SH_FocusFrame_AboveWidget)
        return 1;  // otherwise it lies below the control and is hidden
    return QProxyStyle::styleHint(hint, option, widget, more);
}

QSize TargetStyle::sizeFromContents(ContentsType type, const QStyleOption* option,
                                    const QSize& contents, const QWidget* widget) const
{
    QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    if (type == CT_SpinBox && hasArrows(option)) {
        constexpr int kAround = 8;  // [px] around the number
        size.setWidth(std::max(size.width(), contents.width() + kAround + 2 * target()));
    }
    const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
    if (type == CT_MenuItem && item && item->menuItemType != QStyleOptionMenuItem::Separator)
        size.setHeight(std::max(size.height(), target()));
    return size;
}

}  // namespace terratact
