#include "widgets/base/late_style.h"

#include <QApplication>
#include <QEvent>
#include <QScrollArea>
#include <QSet>
#include <utility>

namespace terratact {
namespace {

class LateStyle final : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() != QEvent::StyleChange && event->type() != QEvent::Show) return false;
        auto* const area = qobject_cast<QScrollArea*>(object);
        if (!area) return false;
        if (event->type() == QEvent::Show) return told(*area);
        if (area->isVisible()) return false;
        if (!untold_.contains(area)) {
            untold_.insert(area);
            connect(area, &QObject::destroyed, this, [this, area] { untold_.remove(area); });
        }
        return true;
    }

private:
    /// Tells an area what it missed; the area shall receive the present event, too.
    bool told(QScrollArea& area)
    {
        if (!untold_.remove(&area)) return false;
        disconnect(&area, &QObject::destroyed, this, nullptr);
        QEvent change(QEvent::StyleChange);
        QCoreApplication::sendEvent(&area, &change);
        return false;
    }

    QSet<const QObject*> untold_;
};

}  // namespace

void tellHiddenAreasLate(QApplication& application)
{
    static bool tells = false;
    if (!std::exchange(tells, true)) application.installEventFilter(new LateStyle(&application));
}

}  // namespace terratact
