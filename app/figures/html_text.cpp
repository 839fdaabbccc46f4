#include "app/figures/html_text.h"

#include <fmt/format.h>

#include "app/figures/canvas.h"
#include "core/base/text.h"

namespace terratact {

std::string htmlText(std::string_view text)
{
    std::string html;
    for (const char c : printable(text)) switch (c) {
        case '<': html += "&lt;"; break;
        case '>': html += "&gt;"; break;
        case '&': html += "&amp;"; break;
        case '"': html += "&quot;"; break;
        case '\'': html += "&#39;"; break;
        default: html += c;
        }
    return html;
}

std::string htmlHead(std::string_view title, const Wording& wording, std::string_view style)
{
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\">"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
        "'unsafe-inline'; img-src data:\">"
        "<title>{}</title>\n"
        "<style>body{{font-family:sans-serif;color:#16222e;max-width:1200px;margin:2em "
        "auto;padding:0 1em}}"
        "svg{{width:100%;height:auto}}table{{border-collapse:collapse;width:100%}}"
        "td,th{{text-align:right;padding:.2em .6em;border-bottom:1px solid #cfd8e1}}"
        "dt{{font-weight:bold;color:#4a5866}}dd{{margin:0 0 .4em "
        "1em;overflow-wrap:anywhere}}{}</style></head>\n",
        htmlText(wording(TR_NOOP("Report", "en"))), htmlText(title), style);
}

std::string htmlPicture(int width, int height, const std::function<void(Canvas&)>& draw,
                        std::string_view prefix)
{
    std::string svg = svgText(width, height, draw);
    svg.erase(0, svg.find("<svg"));
    for (const std::string_view reference : {" id=\"", "href=\"#", "url(#"})
        for (std::size_t at = svg.find(reference); at != std::string::npos;
             at = svg.find(reference, at + 1))
            svg.insert(at + reference.size(), prefix);
    return svg;
}

}  // namespace terratact
