#pragma once

#include <functional>
#include <memory>

#include "app/figures/report/report_document.h"
#include "app/figures/wording.h"
#include "app/link/dbc_book.h"
#include "core/base/result.h"
#include "core/log/session_reader.h"

namespace terratact {

/// Returns the report of a whole session: facts, the strip of felt ground, every decision with its numbers, alarms,
/// settings, hashes. Reads the whole session to check its hash chain. Errors name the file. progress(share) cancels by
/// returning false, which is an Error. book: describes frames of other devices, whose newest values become facts; null:
/// none. wording: makes the texts.
Result<ReportDocument> missionReportOf(SessionReader& session,
                                       const std::function<bool(double)>& progress = {},
                                       const std::shared_ptr<const DbcBook>& book = {},
                                       const Wording& wording = inEnglish);

}  // namespace terratact
