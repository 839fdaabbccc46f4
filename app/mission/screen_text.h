#pragma once

#include "core/atem/link_watch.h"
#include "core/base/message.h"

namespace terratact {

class Exploration;

/// Returns what the console shows at a decision of the operator, for the recording: exploration, link, verdict with its
/// numbers, and the probe: "exploration: ready; link is up; no estimate".
Message screenText(const Exploration& exploration, const LinkAccount& link);

}  // namespace terratact
