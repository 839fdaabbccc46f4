#include <fmt/format.h>

#include "app/figures/canvas.h"
#include "app/figures/figure_colours.h"
#include "app/figures/html_text.h"
#include "app/figures/report/document_pages.h"
#include "app/figures/report/session_report.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

constexpr double kPageMargin = 50.0, kLine = 24.0;

/// A page that is filled from the top.
class Page {
public:
    Page(Canvas& canvas, const Wording& wording) : canvas_(canvas), wording_(wording) {}

    void draw(const SessionReport& report)
    {
        y_ = 62.0;
        write(report.title, {.colour = kFigureText, .size = 27.0, .bold = true}, 34.0);
        write(report.verdict, {.colour = kFigureText, .size = 20.0, .bold = true}, 28.0);
        drawProfiles(report.figures);
        drawTable(report.table);
        for (const auto& [what, text] : report.facts) drawFact(what, text);
        drawEvents(report.events);
    }

private:
    void write(const std::string& text, const TextStyle& style, double line)
    {
        for (const std::string& part :
             canvas_.wrapped(text, kPaperWidth - 2.0 * kPageMargin, style)) {
            canvas_.text({kPageMargin, y_}, part, style);
            y_ += line;
        }
    }

    /// Draws the profiles side by side.
    void drawProfiles(const std::vector<FigureInput>& figures)
    {
        const double width =
            (kPaperWidth - 2.0 * kPageMargin) / static_cast<double>(figures.size());
        const double scale = width / kProfileWidth;
        for (std::size_t k = 0; k < figures.size(); ++k)
            canvas_.place({kPageMargin + width * static_cast<double>(k), y_ - 18.0}, scale,
                          [&](Canvas& canvas) { drawProfile(canvas, figures[k]); });
        y_ += scale * kProfileHeight;
    }

    void drawTable(const std::vector<std::vector<std::string>>& table)
    {
        const double column =
            (kPaperWidth - 2.0 * kPageMargin) / static_cast<double>(table.front().size());
        constexpr std::size_t kRoomy = 11;  // largest number of columns in the usual font size
        const double size = table.front().size() > kRoomy ? 13.5 : 16.0;
        for (std::size_t row = 0; row < table.size(); ++row) {
            const TextStyle style{.colour = row == 0 ? kFigureMuted : kFigureText,
                                  .size = size,
                                  .bold = row == 0,
                                  .align = Align::Right};
            for (std::size_t k = 0; k < table[row].size(); ++k)
                canvas_.text({kPageMargin + column * static_cast<double>(k + 1) - 8.0, y_},
                             table[row][k], style);
            y_ += kLine - 1.0;
            if (row == 0) rule(y_ - 18.0);
        }
        rule(y_ - 16.0);
        y_ += 10.0;
    }

    void rule(double y)
    {
        canvas_.line({kPageMargin, y}, {kPaperWidth - kPageMargin, y}, {kFigureFrame, 1.0, {}});
    }

    void drawFact(const std::string& what, const std::string& text)
    {
        constexpr double kColumn = 130.0;
        const TextStyle heading{.colour = kFigureMuted, .size = 16.0, .bold = true};
        const TextStyle style{.colour = kFigureText, .size = 16.0};
        canvas_.text({kPageMargin, y_}, what, heading);
        for (const std::string& part :
             canvas_.wrapped(text, kPaperWidth - 2.0 * kPageMargin - kColumn, style)) {
            canvas_.text({kPageMargin + kColumn, y_}, part, style);
            y_ += kLine - 1.0;
        }
    }

    /// Draws as many events as fit, and the number of omitted ones.
    void drawEvents(const std::vector<std::string>& events)
    {
        const TextStyle style{.colour = kFigureText, .size = 16.0};
        const double bottom = kPaperHeight - kPageMargin;
        y_ += 8.0;
        write(events.empty() ? wording_(TR_NOOP("Report", "The operator decided nothing here"))
                             : wording_(TR_NOOP("Report", "The operator")),
              {.colour = kFigureMuted, .size = 16.0, .bold = true}, kLine);
        for (std::size_t k = 0; k < events.size(); ++k) {
            const auto lines = canvas_.wrapped(events[k], kPaperWidth - 2.0 * kPageMargin, style);
            const double needed = kLine * static_cast<double>(lines.size());
            const double reserved = k + 1 < events.size() ? kLine : 0.0;
            if (y_ + needed + reserved > bottom) {
                write(wording_(
                          {TR_NOOP("Report", "… and %1 more in the session"), events.size() - k}),
                      style, kLine);
                return;
            }
            write(events[k], style, kLine);
        }
    }

    Canvas& canvas_;
    const Wording& wording_;
    double y_ = 0.0;  ///< base line of the next item
};

std::string htmlOf(const SessionReport& report)
{
    std::string svg;
    for (std::size_t k = 0; k < report.figures.size(); ++k)
        svg += htmlPicture(
            kProfileWidth, kProfileHeight,
            [&](Canvas& canvas) { drawProfile(canvas, report.figures[k]); },
            fmt::format("p{}-", k));
    std::string html = htmlHead(report.title, report.wording);
    html += fmt::format("<body><h1>{0}</h1>\n<p><strong>{1}</strong></p>\n{2}\n<table>\n",
                        htmlText(report.title), htmlText(report.verdict), svg);
    for (std::size_t row = 0; row < report.table.size(); ++row) {
        html += "<tr>";
        for (const std::string& cell : report.table[row])
            html += fmt::format("<{0}>{1}</{0}>", row == 0 ? "th" : "td", htmlText(cell));
        html += "</tr>\n";
    }
    html += "</table>\n<dl>\n";
    for (const auto& [what, text] : report.facts)
        html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", htmlText(what), htmlText(text));
    html += fmt::format("</dl>\n<h2>{}</h2>\n<ul>\n",
                        htmlText(report.wording(TR_NOOP("Report", "The operator"))));
    for (const std::string& event : report.events)
        html += fmt::format("<li>{}</li>\n", htmlText(event));
    return html + "</ul></body></html>\n";
}

}  // namespace

Status writeReport(const std::string& path, const SessionReport& report)
{
    if (path.ends_with(".html")) return writeFileAtomically(path, htmlOf(report));
    return writePicture(path, kPaperWidth, kPaperHeight,
                        [&](Canvas& canvas) { Page(canvas, report.wording).draw(report); });
}

}  // namespace terratact
