#include "app/shell/watched_application.h"

#include <QEvent>
#include <QMetaEnum>
#include <QThread>

#include "app/runtime/steady_now.h"

namespace terratact {
namespace {

const char* classOf(const QObject* object)
{
    return object ? object->metaObject()->className() : nullptr;
}

QString describe(QEvent::Type type, const char* receiver, const char* parent)
{
    const char* name = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
    QString text = name ? QString::fromLatin1(name) : QString::number(type);
    text += QStringLiteral(" for ") + QString::fromLatin1(receiver);
    return parent ? text + QStringLiteral(" of ") + QString::fromLatin1(parent) : text;
}

}  // namespace

bool WatchedApplication::notify(QObject* receiver, QEvent* event)
{
    // Qt calls this for the events of every thread.
    const QThread* here = QThread::currentThread();
    if (!receiver || here != thread() || !watch_.begins(here->loopLevel()))
        return QApplication::notify(receiver, event);
    const int level = here->loopLevel();
    // Both are read before, because the event may delete them.
    const QEvent::Type type = event->type();
    const char* const whose = classOf(receiver);
    const char* const parent = classOf(receiver->parent());
    const double began = steadyNow();
    const bool done = QApplication::notify(receiver, event);
    const double seconds = steadyNow() - began;
    if (watch_.ends(level, seconds))
        watch_.keep({seconds, describe(type, whose, parent), QTime::currentTime()});
    return done;
}

std::vector<LongEvent> WatchedApplication::longestEvents()
{
    const auto* application = dynamic_cast<const WatchedApplication*>(instance());
    return application ? application->watch_.longest() : std::vector<LongEvent>{};
}

}  // namespace terratact
