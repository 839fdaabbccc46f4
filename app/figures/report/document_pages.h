#pragma once

#include <vector>

#include "app/figures/canvas.h"
#include "app/figures/report/report_document.h"

namespace terratact {

inline constexpr int kPaperWidth = 1240, kPaperHeight = 1754;  ///< A4 at 150 px per inch

/// Lays a document out on A4 pages. Headings stay with what follows them. A row of a table stays on
/// one page, and the table's heading is repeated. Each page names the document and counts the
/// pages. measuring: measures texts; nothing is drawn on it. Draw the pages while the document
/// lives.
std::vector<PageDrawing> pagesOf(Canvas& measuring, const ReportDocument& document);

}  // namespace terratact
