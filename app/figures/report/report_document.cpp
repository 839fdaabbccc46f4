#include "app/figures/report/report_document.h"

#include <fmt/format.h>

#include <numeric>

#include "app/figures/canvas.h"
#include "app/figures/html_text.h"
#include "app/figures/report/document_pages.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

std::string tableHtml(const DocumentTable& table)
{
    const auto row = [](const std::vector<std::string>& cells, const char* element) {
        std::string html = "<tr>";
        for (const std::string& cell : cells)
            html += fmt::format("<{0}>{1}</{0}>", element, htmlText(cell));
        return html + "</tr>\n";
    };
    const double sum = std::accumulate(table.shares.begin(), table.shares.end(), 0.0);
    std::string html = "<table>\n";
    for (const double share : table.shares)
        html += fmt::format("<col style=\"width:{:.1f}%\">", 100.0 * share / sum);
    html += "\n" + row(table.heading, "th");
    for (const std::vector<std::string>& cells : table.rows) html += row(cells, "td");
    return html + "</table>\n";
}

std::string pictureHtml(const DocumentPicture& picture, const std::string& prefix)
{
    return fmt::format("<figure role=\"img\" aria-label=\"{}\">{}</figure>\n",
                       htmlText(picture.text),
                       htmlPicture(static_cast<int>(picture.width),
                                   static_cast<int>(picture.height), picture.draw, prefix));
}

std::string partHtml(const DocumentPart& part, std::size_t number)
{
    std::string html = fmt::format("<h2>{}</h2>\n", htmlText(part.heading));
    if (!part.note.empty()) html += fmt::format("<p>{}</p>\n", htmlText(part.note));
    if (!part.facts.empty()) {
        html += "<dl>\n";
        for (const auto& [what, text] : part.facts)
            html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", htmlText(what), htmlText(text));
        html += "</dl>\n";
    }
    for (std::size_t k = 0; k < part.pictures.size(); ++k)
        html += pictureHtml(part.pictures[k], fmt::format("p{}-{}-", number, k));
    if (!part.table.rows.empty()) html += tableHtml(part.table);
    return html;
}

std::string htmlOf(const ReportDocument& document)
{
    std::string html =
        htmlHead(document.title, document.wording,
                 "table{table-layout:fixed}"
                 "td,th{text-align:left;vertical-align:top;overflow-wrap:anywhere}"
                 "dl{display:grid;grid-template-columns:12em 1fr;gap:.2em 1em}dd{margin:0}"
                 "figure{margin:0 0 1em}");
    html += fmt::format("<body><h1>{}</h1>\n<p><strong>{}</strong></p>\n", htmlText(document.title),
                        htmlText(document.summary));
    for (std::size_t k = 0; k < document.parts.size(); ++k) html += partHtml(document.parts[k], k);
    return html + "</body></html>\n";
}

}  // namespace

Status writeDocument(const std::string& path, const ReportDocument& document)
{
    if (path.ends_with(".html")) return writeFileAtomically(path, htmlOf(document));
    if (!path.ends_with(".pdf")) return Error{path + ": a report of pages ends in .pdf or .html"};
    return writePages(path, kPaperWidth, kPaperHeight, document.title,
                      [&](Canvas& measuring) { return pagesOf(measuring, document); });
}

}  // namespace terratact
