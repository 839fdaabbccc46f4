#include "widgets/base/focus_mark.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QFocusFrame>
#include <QLineEdit>
#include <QPainter>
#include <QPointer>
#include <QRadioButton>
#include <utility>

#include "widgets/base/palette.h"

namespace terratact {
namespace {

constexpr int kMarkWidth = 2;  // [px]

/// Paints the frame on the control's edge, because there may be no room outside it.
class FocusMark final : public QFocusFrame {
public:
    using QFocusFrame::QFocusFrame;

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        QPainter painter(this);
        painter.setPen(QPen(theme().contact, kMarkWidth));
        painter.drawRect(
            rect().adjusted(kMarkWidth / 2, kMarkWidth / 2, -kMarkWidth / 2, -kMarkWidth / 2));
    }
};

/// Returns true for controls whose focus the style sheet does not already frame. It frames buttons, fields and text
/// columns.
bool needsMark(const QWidget* widget)
{
    if (!widget || widget->isWindow() || !(widget->focusPolicy() & Qt::TabFocus)) return false;
    const bool box =
        qobject_cast<const QCheckBox*>(widget) || qobject_cast<const QRadioButton*>(widget);
    if (!box && qobject_cast<const QAbstractButton*>(widget)) return false;
    return !qobject_cast<const QLineEdit*>(widget)
        && widget->objectName() != QLatin1String("scrollColumn");
}

}  // namespace

void markFocus(QApplication& application)
{
    static QPointer<FocusMark> mark;  // the focused control's parent owns and deletes it
    static bool marks = false;
    if (std::exchange(marks, true)) return;
    QObject::connect(&application, &QApplication::focusChanged, &application,
                     [](QWidget* /*before*/, QWidget* now) {
                         if (!needsMark(now)) {
                             if (mark) mark->setWidget(nullptr);
                             return;
                         }
                         if (!mark) mark = new FocusMark(now->parentWidget());
                         mark->setWidget(now);
                     });
}

}  // namespace terratact
