#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/figures/profile_figure.h"
#include "core/base/result.h"
#include "core/log/session_reader.h"

namespace terratact {

/// What the report of one scene says, in words.
struct SessionReport {
    std::string title, verdict;
    FigureInput figure;
    std::vector<std::vector<std::string>> table;  ///< the heading first, then a row per bin
    std::vector<std::pair<std::string, std::string>> facts;
    std::vector<std::string> events;  ///< what the operator did, and what was on the screen
};

/// scene: 0 for the last that was estimated.  Reads the whole session to say whether it holds.  Errors name the
/// file: no such scene, or it has no estimate.  progress(share of the batches) may end it by returning false, which
/// is an Error.
Result<SessionReport> reportOf(SessionReader& session, std::int64_t scene,
                               const std::function<bool(double)>& progress = {});

/// One page of A4: PDF, SVG, PNG or HTML by the ending.  What finds no room on the page is counted on it; HTML has
/// room for all.  Written under a temporary name, then renamed.
Status writeReport(const std::string& path, const SessionReport& report);

}  // namespace terratact
