#include "core/log/event_text.h"

namespace terratact {
namespace {

template <class Enum>
std::string wordsOf(const std::optional<Enum>& value, const std::string& recorded)
{
    return value ? std::string(describe(*value)) : recorded;
}

}  // namespace

std::optional<AtemPhase> phaseOf(const EventRow& event)
{
    if (event.kind != EventKind::Phase) return std::nullopt;
    return atemPhaseFromName(event.subject);
}

std::optional<AtemFailure> failureOf(const EventRow& event)
{
    if (event.kind != EventKind::Phase) return std::nullopt;
    return atemFailureFromName(event.text);
}

std::optional<ArmingPhase> armingOf(const EventRow& event)
{
    if (event.kind != EventKind::Arming) return std::nullopt;
    return armingPhaseFromName(event.subject);
}

std::optional<DisarmCause> causeOf(const EventRow& event)
{
    if (event.kind != EventKind::Arming) return std::nullopt;
    return disarmCauseFromName(event.text);
}

std::string subjectWords(const EventRow& event)
{
    if (event.kind == EventKind::Arming) return wordsOf(armingOf(event), event.subject);
    return wordsOf(phaseOf(event), event.subject);
}

std::string textWords(const EventRow& event)
{
    if (event.kind == EventKind::Arming) return wordsOf(causeOf(event), event.text);
    return wordsOf(failureOf(event), event.text);
}

}  // namespace terratact
