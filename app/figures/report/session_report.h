#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/figures/profile_figure.h"
#include "app/figures/wording.h"
#include "app/link/dbc_book.h"
#include "core/base/result.h"
#include "core/log/session_reader.h"

namespace terratact {

/// The report of one scene as text.
struct SessionReport {
    std::string title, verdict;
    Wording wording = inEnglish;                  ///< makes the page's own texts
    std::vector<FigureInput> figures;             ///< one of one plane, or left and right
    std::vector<std::vector<std::string>> table;  ///< heading first, then a row per side and bin
    std::vector<std::pair<std::string, std::string>> facts;
    std::vector<std::string> events;  ///< operator actions and display changes
};

/// Returns the report of a scene; scene 0 is the last estimated one. Reads the whole session to check its hash chain.
/// Errors name the file: no such scene, or a scene without an estimate. progress(share of the batches) cancels by
/// returning false, which is an Error. book: describes frames of other devices, whose newest values at the scene
/// become facts; null: none. wording: makes the texts.
Result<SessionReport> reportOf(SessionReader& session, std::int64_t scene,
                               const std::function<bool(double)>& progress = {},
                               const std::shared_ptr<const DbcBook>& book = {},
                               const Wording& wording = inEnglish);

/// Writes one A4 page as PDF, SVG, PNG or HTML by the file ending. The page counts what does not fit on it; HTML holds
/// everything. The file is written under a temporary name and renamed.
Status writeReport(const std::string& path, const SessionReport& report);

}  // namespace terratact
