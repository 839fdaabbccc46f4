#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/atem/arming.h"
#include "core/atem/atem_machine.h"
#include "core/log/session_rows.h"

namespace terratact {

/// Return what an event of kind Phase or Arming says. Empty for another kind, and for an unknown
/// name.
std::optional<AtemPhase> phaseOf(const EventRow& event);
std::optional<AtemFailure> failureOf(const EventRow& event);
std::optional<ArmingPhase> armingOf(const EventRow& event);
std::optional<DisarmCause> causeOf(const EventRow& event);

/// Return subject and text of an event for the operator. Names get the text of describe(); anything
/// else stays as recorded.
std::string subjectWords(const EventRow& event);
std::string textWords(const EventRow& event);

}  // namespace terratact
