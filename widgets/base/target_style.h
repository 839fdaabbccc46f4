#pragma once

#include <QProxyStyle>

namespace terratact {

/// Fusion style with targets for a gloved hand. The arrows of a spin box stand side by side, each as large as a button.
/// Menu and combo box entries have the same height.
class TargetStyle final : public QProxyStyle {
public:
    TargetStyle();

    QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                         const QWidget* widget) const override;
    /// Draws a number box with the frame of a line of text and its arrows as two buttons. Draws a list to choose from
    /// like a button, and a scroll bar in the theme's colours.
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                            QPainter* painter, const QWidget* widget) const override;
    /// Draws a frame around the box of a check box, which is visible without a check too.
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option,
                    const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* more) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override;
};

}  // namespace terratact
