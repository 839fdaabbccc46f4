#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/figures/wording.h"
#include "core/base/result.h"

namespace terratact {

class Canvas;

/// A picture of a document, drawn from the canvas's origin. It is scaled to the width of the page.
struct DocumentPicture {
    double width = 0.0, height = 0.0;  ///< [px]
    std::string text;                  ///< what it shows, for those who cannot see it
    std::function<void(Canvas&)> draw;
};

/// A table of texts; the columns share the width of the page.
struct DocumentTable {
    std::vector<std::string> heading;
    std::vector<double> shares;  ///< of each column, any unit
    std::vector<std::vector<std::string>> rows;
};

/// A part of a document, in this order on the page.
struct DocumentPart {
    std::string heading;
    std::string note;  ///< one paragraph; empty: none
    std::vector<std::pair<std::string, std::string>> facts;
    std::vector<DocumentPicture> pictures;
    DocumentTable table;  ///< without rows: none
};

/// A document of several pages. All texts are shown plain, whatever they hold.
struct ReportDocument {
    std::string title, summary;
    std::vector<DocumentPart> parts;
    Wording wording = inEnglish;  ///< the language of the page numbers and of the HTML
};

/// Writes A4 pages as PDF, or one HTML file without scripts and with its pictures inside, by the file ending. The same
/// document and fonts give the same bytes. The file is written under a temporary name and renamed. Errors name the
/// file: another ending, no font, or not writable.
Status writeDocument(const std::string& path, const ReportDocument& document);

}  // namespace terratact
