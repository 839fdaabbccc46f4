#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/atem/arming.h"
#include "core/atem/atem_machine.h"
#include "core/log/session_rows.h"

namespace terratact {

/// What an event of kind Phase or Arming says; empty: of another kind, or the name is not known.
std::optional<AtemPhase> phaseOf(const EventRow& event);
std::optional<AtemFailure> failureOf(const EventRow& event);
std::optional<ArmingPhase> armingOf(const EventRow& event);
std::optional<DisarmCause> causeOf(const EventRow& event);

/// The subject and the text of an event in words for the operator: of names those of describe(), else what is
/// recorded.
std::string subjectWords(const EventRow& event);
std::string textWords(const EventRow& event);

}  // namespace terratact
