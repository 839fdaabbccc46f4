#pragma once

#include "core/log/session_rows.h"

namespace terratact {

/// An event of a session of version 1 or 2 as version 3 has it.  Those versions hold a phase, a failure and a cause of
/// disarming in the words that the operator read then; since version 3 they are held by name.  The words are frozen:
/// rewording what an operator reads does not change this table.  Other events, and words that no session of those
/// versions holds, stay as they are.
EventRow withNames(EventRow event);

}  // namespace terratact
