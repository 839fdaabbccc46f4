#include "widgets/base/target_style.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOptionComboBox>
#include <QStyleOptionMenuItem>
#include <QStyleOptionSlider>
#include <QStyleOptionSpinBox>
#include <algorithm>
#include <utility>

#include "widgets/base/palette.h"
#include "widgets/base/style_sheet.h"
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

/// Returns the colour of a part that can be pressed.
QColor areaOf(const Fill& fill, bool isUnder, bool isDown)
{
    if (isDown) return mixed(fill.area, QColor(Qt::black), 0.3);
    return isUnder ? mixed(fill.area, fill.text, 0.1) : fill.area;
}

/// Returns an arrow at a place, in the state of its box.
QStyleOption arrowIn(const QRect& place, const QStyleOption& box)
{
    QStyleOption arrow(box);
    arrow.rect = place;
    return arrow;
}

/// Draws the box of a list to choose from like a button, with an arrow.
void drawChoice(const QStyle& style, const QStyleOptionComboBox& box, const QRect& arrow,
                QPainter& painter, const QWidget* widget)
{
    constexpr double kRadius = 5.0;  // [px] as buttons in theme.qss
    const bool isOn = box.state & QStyle::State_Enabled;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(isOn ? theme().buttonBorder : theme().offBorder);
    painter.setBrush(isOn ? areaOf(theme().button, box.state & QStyle::State_MouseOver,
                                   box.state & (QStyle::State_Sunken | QStyle::State_On))
                          : theme().off.area);
    painter.drawRoundedRect(QRectF(box.rect).adjusted(0.5, 0.5, -0.5, -0.5), kRadius, kRadius);
    painter.restore();
    const QStyleOption mark = arrowIn(arrow, box);
    style.drawPrimitive(QStyle::PE_IndicatorArrowDown, &mark, &painter, widget);
}

/// Draws an arrow of a number box as a separate button.
void drawStep(const QStyle& style, const QStyleOptionSpinBox& box, QStyle::SubControl part,
              QPainter& painter, const QWidget* widget)
{
    const bool isUp = part == QStyle::SC_SpinBoxUp;
    const bool isActive = box.activeSubControls == part;
    const bool isOn =
        (box.state & QStyle::State_Enabled)
        && (box.stepEnabled
            & (isUp ? QAbstractSpinBox::StepUpEnabled : QAbstractSpinBox::StepDownEnabled));
    const QRect around = style.subControlRect(QStyle::CC_SpinBox, &box, part, widget);
    const QColor area =
        isOn ? areaOf(theme().button, isActive && (box.state & QStyle::State_MouseOver),
                      isActive && (box.state & QStyle::State_Sunken))
             : theme().off.area;
    painter.save();
    painter.fillRect(around, area);
    painter.setPen(theme().muted);
    painter.drawRect(around.adjusted(0, 0, -1, -1));
    painter.restore();
    QStyleOption mark = arrowIn(around, box);
    mark.state.setFlag(QStyle::State_Enabled, isOn);
    style.drawPrimitive(isUp ? QStyle::PE_IndicatorArrowUp : QStyle::PE_IndicatorArrowDown, &mark,
                        &painter, widget);
}

/// Draws a scroll bar: a groove, an arrow at each end, and the slider with a frame.
void drawScrollBar(const QStyle& style, const QStyleOptionSlider& bar, QPainter& painter,
                   const QWidget* widget)
{
    const auto part = [&](QStyle::SubControl which) {
        return style.subControlRect(QStyle::CC_ScrollBar, &bar, which, widget);
    };
    const auto colourOf = [&](QStyle::SubControl which) {
        const bool isUnder = bar.activeSubControls & which;
        return areaOf(theme().button, isUnder && (bar.state & QStyle::State_MouseOver),
                      isUnder && (bar.state & QStyle::State_Sunken));
    };
    painter.fillRect(bar.rect, mixed(theme().window, theme().text, 0.06));
    const bool isLevel = bar.orientation == Qt::Horizontal;
    const bool toLeft = isLevel && bar.direction == Qt::RightToLeft;
    const auto less = isLevel ? QStyle::PE_IndicatorArrowLeft : QStyle::PE_IndicatorArrowUp;
    const auto more = isLevel ? QStyle::PE_IndicatorArrowRight : QStyle::PE_IndicatorArrowDown;
    for (const auto& [which, arrow] :
         {std::pair{QStyle::SC_ScrollBarSubLine, toLeft ? more : less},
          std::pair{QStyle::SC_ScrollBarAddLine, toLeft ? less : more}}) {
        painter.fillRect(part(which), colourOf(which));
        const QStyleOption mark = arrowIn(part(which), bar);
        style.drawPrimitive(arrow, &mark, &painter, widget);
    }
    const QRect slider = part(QStyle::SC_ScrollBarSlider);
    painter.fillRect(slider, colourOf(QStyle::SC_ScrollBarSlider));
    drawFrame(painter, slider);
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
    const auto* choice = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    if (control == CC_ComboBox && choice && !choice->editable) {
        const QRect arrow = subControlRect(control, option, SC_ComboBoxArrow, widget);
        return drawChoice(*proxy(), *choice, arrow, *painter, widget);
    }
    // Qt's own has a white line, which the night theme must not show.
    if (const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
        bar && control == CC_ScrollBar)
        return drawScrollBar(*proxy(), *bar, *painter, widget);
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_SpinBox && hasArrows(option))
        for (const SubControl part : {SC_SpinBoxDown, SC_SpinBoxUp})
            drawStep(*proxy(), *qstyleoption_cast<const QStyleOptionSpinBox*>(option), part,
                     *painter, widget);
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
    constexpr int kBesideCells = 4;  // [px] between a cell's text and its edge
    if (metric == PM_FocusFrameHMargin && qobject_cast<const QAbstractItemView*>(widget))
        return kBesideCells;
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
