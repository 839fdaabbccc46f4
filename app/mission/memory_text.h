#pragma once

#include <optional>

#include "app/mission/way_memory.h"
#include "core/base/message.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/strip/strip_ledger.h"
#include "core/strip/strip_section.h"

namespace terratact {

/// Returns "no memory: …" with a reason.
Message noMemory(const Message& why);

/// Returns the text beside an estimate: how much it remembers, or why nothing. Empty if the method wanted is not Trail.
/// networks: of the model in use.
Message memoryText(Method wanted, const SceneMemory& memory, const TrailInUse& networks);
/// Returns the same for an estimate that is there: it cannot use its memory without a current or a force.
Message memoryText(const TwoTrackEstimate& estimate, const TrailHistory* memory);

/// Returns the text with two counts: touches of remembered ground, and those within its 80 % band.
/// Nothing is added before the first such touch.
Message withLedger(const Message& words, const StripLedger& ledger);

/// Returns why nothing is remembered: the strip's reason, or no telemetry. Empty: something is, or nothing was felt
/// yet.
std::optional<Message> nothingRememberedText(std::optional<SectionStart> why, bool telemetryFresh);

}  // namespace terratact
