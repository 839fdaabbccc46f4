#include "widgets/base/calm_wheel.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>

namespace terratact {

bool CalmWheel::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() != QEvent::Polish && event->type() != QEvent::Wheel) return false;
    if (!qobject_cast<QAbstractSpinBox*>(object) && !qobject_cast<QComboBox*>(object)) return false;
    auto* box = static_cast<QWidget*>(object);
    if (event->type() == QEvent::Polish) {
        // Qt's wheel focus policy would give the control the focus before this filter sees the wheel.
        if (box->focusPolicy() == Qt::WheelFocus) box->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (box->hasFocus()) return false;
    event->ignore();  // the page below takes the wheel event
    return true;
}

}  // namespace terratact
