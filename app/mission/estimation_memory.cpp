#include <utility>

#include "app/mission/estimation.h"
#include "app/mission/memory_text.h"

namespace terratact {

Message Estimation::memoryText() const
{
    if (!estimate_ || memoryText_.empty()) return {};
    const SceneMemory& memory = scene_->memory;
    const Message used =
        terratact::memoryText(*estimate_, memory.history ? &*memory.history : nullptr);
    return used.empty() ? memoryText_ : used;
}

/// Reports that nothing is remembered, and each new reason.
void Estimation::announceMemory()
{
    const bool isRemembered = estimate_->side[0].settings.method == Method::Trail;
    const Message why = isRemembered ? Message() : memoryText_;
    if (std::exchange(memoryLogged_, why) != why && !why.empty())
        emit happened(why, EventSeverity::Note);
}

SeenStrip Estimation::remembered() const
{
    return telemetryFresh_ ? strip_.seen() : SeenStrip{};
}

std::optional<Message> Estimation::whyNothingRemembered() const
{
    if (counts_.estimates == 0) return std::nullopt;
    return nothingRememberedText(strip_.whyNothing(), telemetryFresh_);
}

}  // namespace terratact
