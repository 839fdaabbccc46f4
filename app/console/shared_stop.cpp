#include "app/console/shared_stop.h"

#include <utility>

namespace terratact {

SharedStop::SharedStop(Exploration& exploration, QObject* parent)
    : QObject(parent), exploration_(exploration)
{
    connect(&remote_, &RemoteStop::reported, this, &SharedStop::happened);
    connect(&remote_, &RemoteStop::reported, this, &SharedStop::reported);
    connect(&exploration, &Exploration::stoppedNothing, this, &SharedStop::stoppedNothing);
}

void SharedStop::listen()
{
    if (exploration_.following()) return;
    auto line = stopLineName().empty() ? Result<StopLine>(Error{TR_NOOP(
                    "terratact::SharedStop", "no folder can be made for it in TMPDIR or /tmp")})
                                       : StopLine::listen(stopLineName());
    if (line)
        line_.emplace(std::move(*line));
    else
        emit happened(Message(TR_NOOP("terratact::SharedStop",
                                      "STOP has no effect in windows opened from here: %1"),
                              line.error().message),
                      EventSeverity::Warning);
}

void SharedStop::poll()
{
    if (!line_ || !line_->consume()) return;
    const Message where =
        TR_NOOP("terratact::SharedStop", "STOP was pressed in a window that was opened from here");
    emit received(where);
    exploration_.stopFrom(where);
}

std::string SharedStop::line() const
{
    return line_ ? stopLineName() : std::string();
}

void SharedStop::stoppedNothing(const Message& why)
{
    if (remote_.exists()) return remote_.press();
    emit happened(Message(TR_NOOP("terratact::SharedStop", "STOP has no effect: %1"), why),
                  EventSeverity::Bad);
    emit reported(Message(TR_NOOP("terratact::SharedStop", "STOP HAS NO EFFECT HERE: %1"), why));
}

}  // namespace terratact
