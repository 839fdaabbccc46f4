#include "app/shell/number_box.h"

#include <cmath>

#include "widgets/base/palette.h"
#include "widgets/base/tips.h"

namespace terratact {

QDoubleSpinBox* numberBox(QWidget* parent, const NumberBoxText& text)
{
    auto* box = new RoomyBox<QDoubleSpinBox>(parent);
    box->setDecimals(text.decimals);
    box->setRange(text.range.least / text.unit, text.range.most / text.unit);
    box->setSingleStep(std::pow(10.0, -text.decimals));
    box->setSuffix(QLatin1Char(' ') + text.suffix);
    box->setKeyboardTracking(false);
    box->setMinimumHeight(kTarget);
    box->setAccessibleName(text.label);
    setTip(*box, text.tip);
    return box;
}

}  // namespace terratact
