#include "app/mission/memory_text.h"

#include "app/display/format.h"
#include "app/display/translated.h"
#include "core/infer/trail_form.h"

namespace terratact {
namespace {

Message remembered(const TrailHistory& memory)
{
    const Message way = verbatim(format::number(memory.way, 2));
    if (memory.presses == 0) return {TR_NOOP("terratact::Estimation", "memory: %1 m"), way};
    return {TR_NOOP("terratact::Estimation", "memory: %1 m · earlier presses: %2"), way,
            memory.presses};
}

/// Names the reason why only what the arm measured earlier counts.
Message armAlone(const Message& why)
{
    return {TR_NOOP("terratact::Estimation", "no memory but of the arm: %1"), why};
}

}  // namespace

Message noMemory(const Message& why)
{
    return {TR_NOOP("terratact::Estimation", "no memory: %1"), why};
}

Message memoryText(Method wanted, const SceneMemory& memory, const TrailInUse& networks)
{
    if (wanted != Method::Trail) return {};
    if (networks.name.isEmpty())
        return noMemory(networks.trouble.empty()
                            ? TR_NOOP("terratact::Estimation", "the model has no networks for it")
                            : networks.trouble);
    return memory.history ? remembered(*memory.history) : memory.why;
}

Message memoryText(const TwoTrackEstimate& estimate, const TrailHistory* memory)
{
    if (estimate.side[0].settings.method != Method::Trail || !memory) return {};
    if (estimate.side[0].missing.any() || estimate.side[1].missing.any())
        return armAlone(TR_NOOP("terratact::Estimation", "a current or a force was not measured"));
    if (isForgotten(estimate.side[0]))
        return armAlone(TR_NOOP("terratact::Estimation", "the networks do not know such a pose"));
    return remembered(*memory);
}

Message withLedger(const Message& words, const StripLedger& ledger)
{
    const StripScore all = ledger.all();
    if (all.n == 0) return words;
    Message held(TR_NOOP("terratact::Estimation", "bands held: %1 of %2"),
                 static_cast<int>(all.in80), static_cast<int>(all.n));
    if (words.empty()) return held;
    return {TR_NOOP("terratact::Estimation", "%1 · %2"), words, held};
}

std::optional<Message> nothingRememberedText(std::optional<SectionStart> why, bool telemetryFresh)
{
    if (why == SectionStart::First) return std::nullopt;
    if (why)
        return Message(TR_NOOP("terratact::Estimation", "Nothing is remembered here: %1"),
                       describe(*why));
    if (telemetryFresh) return std::nullopt;
    return TR_NOOP("terratact::Estimation", "No remembered ground while telemetry is missing");
}

}  // namespace terratact
