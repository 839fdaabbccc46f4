#pragma once

#include <optional>
#include <string_view>

#include "core/atem/arming.h"
#include "core/atem/atem_machine.h"
#include "core/base/message.h"
#include "core/log/rows/session_rows.h"

namespace terratact {

/// Return the enumerator that an event of kind Phase or Arming holds. Empty for another kind, and
/// for an unknown name.
std::optional<AtemPhase> phaseOf(const EventRow& event);
std::optional<AtemFailure> failureOf(const EventRow& event);
std::optional<ArmingPhase> armingOf(const EventRow& event);
std::optional<DisarmCause> causeOf(const EventRow& event);

/// Returns the event with this text in English, and as a message if that has anything to translate.
EventRow withText(EventRow event, Message text);

/// Returns the event's text for the operator. It is that of describe() for a failure or a cause of
/// disarming, else the event's message. Without a message it is recordedSentence() of the English
/// text. A note of the operator stays as it is. Sentences of earlier versions become those of
/// today.
Message messageOf(const EventRow& event);

/// Returns the event's subject for the operator: the text of describe() for a phase; else the name
/// as recorded.
Message subjectOf(const EventRow& event);

/// Returns the event with this text as what was on the screen, in English and as a message.
EventRow withScreen(EventRow event, Message screen);

/// Returns what was on the screen, for the operator: in parts, or the English text of versions 1 to
/// 5.
Message screenOf(const EventRow& event);

}  // namespace terratact
