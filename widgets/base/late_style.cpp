#include "widgets/base/late_style.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QEvent>
#include <QSet>
#include <utility>

namespace terratact {
namespace {

/// Returns true for a scroll area, and for the part of one that shows its content.
bool laysOutContent(const QObject* object)
{
    if (qobject_cast<const QAbstractScrollArea*>(object)) return true;
    const auto* const area = qobject_cast<const QAbstractScrollArea*>(object->parent());
    return area && area->viewport() == object;
}

class LateStyle final : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() == QEvent::Show) return restyle(object);
        if (event->type() != QEvent::StyleChange || !laysOutContent(object)) return false;
        if (static_cast<QWidget*>(object)->isVisible()) return false;
        if (!pending_.contains(object)) {
            pending_.insert(object);
            connect(object, &QObject::destroyed, this, [this, object] { pending_.remove(object); });
        }
        return true;
    }

private:
    /// Sends an area a style change if it missed one. Returns false, so that the area also gets the present event.
    bool restyle(QObject* area)
    {
        if (!pending_.remove(area)) return false;
        disconnect(area, &QObject::destroyed, this, nullptr);
        QEvent change(QEvent::StyleChange);
        QCoreApplication::sendEvent(area, &change);
        return false;
    }

    QSet<const QObject*> pending_;
};

}  // namespace

void restyleHiddenAreasLate(QApplication& application)
{
    static bool isInstalled = false;
    if (!std::exchange(isInstalled, true))
        application.installEventFilter(new LateStyle(&application));
}

}  // namespace terratact
