#pragma once

#include <QString>

#include "app/shell/preferences/preferences.h"

class QDoubleSpinBox;
class QWidget;

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

/// Returns a number box that reports only complete numbers, named for screen readers.
QDoubleSpinBox* numberBox(QWidget* parent, const NumberBoxText& text);

}  // namespace terratact
