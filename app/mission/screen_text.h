#pragma once

#include "core/atem/link_watch.h"
#include "core/base/message.h"

namespace terratact {

class Exploration;

/// Returns what the console shows at a decision of the operator, for the recording. It has exploration, link, verdict
/// with its numbers, and the probe. An example is "exploration: ready; link is up; no estimate".
Message screenText(const Exploration& exploration, const LinkAccount& link);

}  // namespace terratact
