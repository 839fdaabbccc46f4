#pragma once

#include <QDoubleSpinBox>
#include <QString>
#include <algorithm>

#include "app/shell/preferences/preferences.h"
#include "widgets/base/palette.h"

namespace terratact {

/// What a number box shows. range: in SI; unit: one unit of the box in SI.
struct NumberBoxText {
    QString label;
    PreferenceRange range;
    int decimals = 2;
    QString suffix{};
    QString tip{};
    double unit = 1.0;
};

/// A QSpinBox or QDoubleSpinBox whose minimum width fits its number. All boxes have the same minimum width, because a
/// form shrinks its fields to their minimum beside a long label.
template <class Box>
class RoomyBox final : public Box {
public:
    using Box::Box;
    QSize minimumSizeHint() const override
    {
        constexpr int kMinWidth = 180;  // [px] at 100 %
        const QSize usual = Box::minimumSizeHint();
        return {std::max({usual.width(), Box::sizeHint().width(), scaled(kMinWidth)}),
                usual.height()};
    }
};

/// Returns a number box that reports only complete numbers, named for screen readers.
QDoubleSpinBox* numberBox(QWidget* parent, const NumberBoxText& text);

}  // namespace terratact
