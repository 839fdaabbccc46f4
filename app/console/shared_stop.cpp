#include "app/console/shared_stop.h"

#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"

namespace terratact {

SharedStop::SharedStop(Exploration& exploration, QObject* parent)
    : QObject(parent), exploration_(exploration)
{
    connect(&remote_, &RemoteStop::said, this, &SharedStop::happened);
    connect(&remote_, &RemoteStop::said, this, &SharedStop::said);
    connect(&exploration, &Exploration::stoppedNothing, this, &SharedStop::stoppedNothing);
}

void SharedStop::listen()
{
    if (exploration_.following()) return;
    auto line = StopLine::listen(stopLineName());
    if (line)
        line_.emplace(std::move(*line));
    else
        emit happened(tr("STOP has no effect in windows opened from here: %1")
                          .arg(translated(line.error().message)),
                      EventSeverity::Warning);
}

void SharedStop::poll()
{
    if (!line_ || !line_->consume()) return;
    const QString where = tr("STOP was pressed in a window that was opened from here");
    emit received(where);
    exploration_.stopFrom(where);
}

std::string SharedStop::line() const
{
    return line_ ? stopLineName() : std::string();
}

void SharedStop::stoppedNothing(const QString& why)
{
    if (remote_.exists()) return remote_.press();
    emit happened(tr("STOP has no effect: %1").arg(why), EventSeverity::Bad);
    emit said(tr("STOP HAS NO EFFECT HERE: %1").arg(why));
}

}  // namespace terratact
