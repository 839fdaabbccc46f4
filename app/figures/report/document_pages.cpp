#include "app/figures/report/document_pages.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "app/figures/figure_colours.h"
#include "core/base/text.h"

namespace terratact {
namespace {

constexpr double kBorder = 70.0, kSheetTop = 90.0, kSheetBottom = kPaperHeight - 90.0;
constexpr double kSheetWidth = kPaperWidth - 2.0 * kBorder, kFactColumn = 190.0;
constexpr double kCellGap = 14.0;
const TextStyle kBodyStyle{.colour = kFigureText, .size = 16.0};
const TextStyle kMutedStyle{.colour = kFigureMuted, .size = 16.0, .bold = true};
const TextStyle kPartStyle{.colour = kFigureText, .size = 21.0, .bold = true};
constexpr double kBodyLine = 22.0;

/// Fills pages from the top and keeps what is to be drawn on each.
class PageFlow {
public:
    explicit PageFlow(Canvas& measuring) : measuring_(measuring) { turn(); }

    void add(const DocumentPart& part)
    {
        y_ += 26.0;
        reserve(110.0 + (part.pictures.empty() ? 0.0 : heightOf(part.pictures.front())));
        write(part.heading, kPartStyle, 30.0);
        if (!part.note.empty()) write(part.note, kBodyStyle, kBodyLine);
        for (const auto& [what, text] : part.facts) addFact(what, text);
        for (const DocumentPicture& picture : part.pictures) addPicture(picture);
        if (!part.table.rows.empty()) addTable(part.table);
    }

    void write(const std::string& text, const TextStyle& style, double line)
    {
        for (std::string& part : wrapped(text, kSheetWidth, style)) {
            reserve(line);
            put(kBorder, std::move(part), style);
            y_ += line;
        }
    }

    /// Returns the pages with a footer.
    std::vector<PageDrawing> finish(const ReportDocument& document) const
    {
        std::vector<PageDrawing> pages;
        pages.reserve(pages_.size());
        for (std::size_t k = 0; k < pages_.size(); ++k)
            pages.emplace_back(
                [drawings = pages_[k], title = printable(document.title),
                 number = printable(document.wording(
                     {TR_NOOP("Report", "page %1 of %2"), k + 1, pages_.size()}))](Canvas& canvas) {
                    for (const PageDrawing& draw : drawings) draw(canvas);
                    const TextStyle left{.colour = kFigureMuted, .size = 14.0};
                    TextStyle right = left;
                    right.align = Align::Right;
                    canvas.text({kBorder, kPaperHeight - 46.0},
                                canvas.fitted(title, kSheetWidth - 160.0, left), left);
                    canvas.text({kPaperWidth - kBorder, kPaperHeight - 46.0}, number, right);
                });
        return pages;
    }

private:
    std::vector<std::string> wrapped(const std::string& text, double width, const TextStyle& style)
    {
        return measuring_.wrapped(printable(text), width, style);
    }

    void turn()
    {
        pages_.emplace_back();
        y_ = kSheetTop;
    }

    /// Begins the next page unless `height` [px] is left on this one.
    void reserve(double height)
    {
        if (y_ + height > kSheetBottom && y_ > kSheetTop) turn();
    }

    void put(double x, std::string text, const TextStyle& style)
    {
        pages_.back().emplace_back([at = Point{x, y_}, text = std::move(text),
                                    style](Canvas& canvas) { canvas.text(at, text, style); });
    }

    void rule(double y, const Colour& colour)
    {
        pages_.back().emplace_back([y, colour](Canvas& canvas) {
            canvas.line({kBorder, y}, {kPaperWidth - kBorder, y}, {colour, 1.0, {}});
        });
    }

    void addFact(const std::string& what, const std::string& text)
    {
        reserve(kBodyLine);
        put(kBorder, measuring_.fitted(printable(what), kFactColumn - kCellGap, kMutedStyle),
            kMutedStyle);
        const auto lines = wrapped(text, kSheetWidth - kFactColumn, kBodyStyle);
        for (const std::string& line : lines) {
            reserve(kBodyLine);
            put(kBorder + kFactColumn, line, kBodyStyle);
            y_ += kBodyLine;
        }
        if (lines.empty()) y_ += kBodyLine;
    }

    static double heightOf(const DocumentPicture& picture)
    {
        return picture.height * kSheetWidth / picture.width;
    }

    void addPicture(const DocumentPicture& picture)
    {
        const double height = heightOf(picture);
        reserve(height);
        pages_.back().emplace_back(
            [at = Point{kBorder, y_ - 14.0}, scale = kSheetWidth / picture.width,
             draw = picture.draw](Canvas& canvas) { canvas.place(at, scale, draw); });
        y_ += height + 8.0;
    }

    /// The cells of a row, in lines.
    using Cells = std::vector<std::vector<std::string>>;

    void addTable(const DocumentTable& table)
    {
        const double sum = std::accumulate(table.shares.begin(), table.shares.end(), 0.0);
        std::vector<double> widths;
        widths.reserve(table.shares.size());
        for (const double share : table.shares) widths.push_back(share / sum * kSheetWidth);
        y_ += 4.0;
        const Cells heading = linesOf(table.heading, widths, kMutedStyle);
        addRow(heading, widths, kMutedStyle);
        for (const std::vector<std::string>& row : table.rows) {
            const Cells cells = linesOf(row, widths, kBodyStyle);
            if (y_ + heightOf(cells) > kSheetBottom) {
                turn();
                addRow(heading, widths, kMutedStyle);
            }
            addRow(cells, widths, kBodyStyle);
        }
    }

    Cells linesOf(const std::vector<std::string>& row, const std::vector<double>& widths,
                  const TextStyle& style)
    {
        Cells cells;
        cells.reserve(row.size());
        for (std::size_t k = 0; k < row.size() && k < widths.size(); ++k)
            cells.push_back(wrapped(row[k], widths[k] - kCellGap, style));
        return cells;
    }

    static double heightOf(const Cells& cells)
    {
        std::size_t lines = 1;
        for (const std::vector<std::string>& cell : cells) lines = std::max(lines, cell.size());
        return kBodyLine * static_cast<double>(lines) + 6.0;
    }

    /// Draws a row; what is longer than a page goes on at the next one.
    void addRow(const Cells& cells, const std::vector<double>& widths, const TextStyle& style)
    {
        std::size_t lines = 1;
        for (const std::vector<std::string>& cell : cells) lines = std::max(lines, cell.size());
        for (std::size_t line = 0; line < lines; ++line) {
            reserve(kBodyLine);
            double x = kBorder;
            for (std::size_t k = 0; k < cells.size(); ++k) {
                if (line < cells[k].size()) put(x, cells[k][line], style);
                x += widths[k];
            }
            y_ += kBodyLine;
        }
        rule(y_ - 14.0, kFigureFrame);
        y_ += 6.0;
    }

    Canvas& measuring_;
    std::vector<std::vector<PageDrawing>> pages_;
    double y_ = 0.0;  ///< base line of the next item
};

}  // namespace

std::vector<PageDrawing> pagesOf(Canvas& measuring, const ReportDocument& document)
{
    PageFlow flow(measuring);
    flow.write(document.title, {.colour = kFigureText, .size = 30.0, .bold = true}, 40.0);
    flow.write(document.summary, {.colour = kFigureText, .size = 19.0, .bold = true}, 28.0);
    for (const DocumentPart& part : document.parts) flow.add(part);
    return flow.finish(document);
}

}  // namespace terratact
