#pragma once

#include "core/log/rows/session_rows.h"

namespace terratact {

/// Converts an event of session version 1 or 2 to version 3. The old versions store phases,
/// failures and causes of disarming as the operator's text of that time. Version 3 stores their
/// names. This table of old texts is frozen: it does not change with the operator's texts. Other
/// events and unknown texts stay unchanged.
EventRow withNames(EventRow event);

}  // namespace terratact
