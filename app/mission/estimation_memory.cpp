#include <utility>

#include "app/mission/estimation.h"
#include "app/mission/memory_text.h"

namespace terratact {

Message Estimation::memoryWords() const
{
    if (!estimate_ || memoryWords_.empty()) return {};
    const SceneMemory& memory = scene_->memory;
    const Message used =
        terratact::memoryWords(*estimate_, memory.history ? &*memory.history : nullptr);
    return used.empty() ? memoryWords_ : used;
}

/// Reports that nothing is remembered, and each new reason.
void Estimation::announceMemory()
{
    const bool isRemembered = estimate_->side[0].settings.method == Method::Trail;
    const Message why = isRemembered ? Message() : memoryWords_;
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
    return nothingRememberedWords(strip_.whyNothing(), telemetryFresh_);
}

}  // namespace terratact
