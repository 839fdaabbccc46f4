#include "core/log/event_text.h"

#include <utility>

#include "core/log/recorded_sentences.h"

namespace terratact {
namespace {

template <class Enum>
Message messageOr(const std::optional<Enum>& value, const std::string& recorded)
{
    return value ? Message(describe(*value)) : recordedSentence(recorded);
}

/// A sentence that earlier recordings hold, and the one that is shown for it; both have the same
/// places.
struct FormerText {
    const char* recorded;
    SourceText now;
};

constexpr FormerText kFormerTexts[] = {
    {"a step ahead of more than %1 mm: probability %2 ± %3, likeliest between %4 and %5 m (%6)",
     TR_NOOP("core", "a step ahead of more than %1 mm: probability %2 ± %3, most likely at "
                     "%4 m … %5 m (%6)")},
    {"the tracks moved less than the advance asked for",
     TR_NOOP("core", "the tracks moved less than the commanded advance")},
    {"the tracks moved further than the advance asked for",
     TR_NOOP("core", "the tracks moved further than the commanded advance")},
    {"line %1 of %2 is asked for twice", TR_NOOP("core", "line %1 of %2 is requested twice")},
    {"%1: mend or delete the line", TR_NOOP("core", "%1: correct or delete the line")},
    {"expected %1, found %2: mend or delete the line",
     TR_NOOP("core", "expected %1, found %2: correct or delete the line")},
    {"%1 sessions of %2 MB are beyond the limits that you have set; none is deleted until you "
     "allow it on page Settings",
     TR_NOOP("core", "%1 sessions (%2 MB) exceed your limits. None is deleted until you allow it "
                     "on page Settings")},
    {"memory begins anew: %1", TR_NOOP("terratact::Estimation", "memory cleared: %1")},
    {"no probe is asked for: %1", TR_NOOP("terratact::Exploration", "no probe requested: %1")},
    {"probe asked for %1 instead", TR_NOOP("terratact::Exploration", "probe %1 requested instead")},
    {"no probe is asked for: the picture shows an estimate of the past",
     TR_NOOP("terratact::MainWindow", "no probe requested: the picture shows an earlier estimate")},
    {"colours and letters change once the robot stands still",
     TR_NOOP("terratact::MainWindow", "colours and font change once the robot has stopped")},
    {"the gamepad is lost: everything that it held is let go",
     TR_NOOP("terratact::GamepadControl", "gamepad lost: all its controls are released")},
};

/// Returns the message with today's sentences, in its arguments too.
Message withoutFormerTexts(Message message)
{
    for (const FormerText& text : kFormerTexts)
        if (message.source == text.recorded && message.context == text.now.context)
            message.source = text.now.english;
    for (Message& argument : message.arguments) argument = withoutFormerTexts(std::move(argument));
    return message;
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

EventRow withText(EventRow event, Message text)
{
    event.text = text.english();
    const bool isTranslated = !text.context.empty() || !text.arguments.empty();
    if (isTranslated) event.message = std::move(text);
    return event;
}

EventRow withScreen(EventRow event, Message screen)
{
    event.shown = screen.english();
    event.screen = std::move(screen);
    return event;
}

Message screenOf(const EventRow& event)
{
    return event.screen.empty() ? Message::verbatim(event.shown) : event.screen;
}

Message messageOf(const EventRow& event)
{
    if (!event.message.empty()) return withoutFormerTexts(event.message);
    if (event.kind == EventKind::Marker) return Message::verbatim(event.text);  // a note
    if (event.kind == EventKind::Arming) return messageOr(causeOf(event), event.text);
    return messageOr(failureOf(event), event.text);
}

Message subjectOf(const EventRow& event)
{
    if (event.kind == EventKind::Arming) return messageOr(armingOf(event), event.subject);
    return messageOr(phaseOf(event), event.subject);
}

}  // namespace terratact
