#include "app/figures/report/strip_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/figures/canvas.h"
#include "app/figures/figure_colours.h"
#include "core/terrain/bins.h"

namespace terratact {
namespace {

constexpr double kStripWidth = 1200.0, kStripLeft = 70.0, kStripRight = 20.0;
constexpr double kStripHead = 110.0, kStripFoot = 46.0;
constexpr double kStripScale = (kStripWidth - kStripLeft - kStripRight) / kStripPiece;  // [px/m]
constexpr double kMinRange = 0.4;                                                       // [m]
constexpr double kScaleBar = 0.5;                                                       // [m]
constexpr double kMaxSheet = 20000.0;  // [px] 100 MB as a picture of points
constexpr Colour kStripLeftSide{0x1558a6}, kStripRightSide{0xb06400}, kStripBoth{0x12804a};

/// Piece of a section between two columns.
struct StripPiece {
    std::shared_ptr<const Strip> strip;
    const StripSection* section = nullptr;
    std::size_t number = 0;        ///< of the section, from 1
    int first = 0, last = 0;       ///< columns
    double low = 0.0, high = 0.0;  ///< [m] range of heights
    Wording wording = inEnglish;
};

std::size_t sidesOf(const StripPiece& piece)
{
    for (auto at = piece.section->columns.lower_bound(piece.first);
         at != piece.section->columns.end() && at->first <= piece.last; ++at)
        for (const std::optional<StripBin>& bin : at->second)
            if (bin && !piece.strip->source(*bin).onePlane) return 2;
    return 1;
}

void setRange(StripPiece& piece)
{
    double low = 1e9, high = -1e9;
    for (auto at = piece.section->columns.lower_bound(piece.first);
         at != piece.section->columns.end() && at->first <= piece.last; ++at)
        for (const std::optional<StripBin>& bin : at->second)
            if (bin) {
                low = std::min({low, bin->band.q10, bin->band.height});
                high = std::max({high, bin->band.q90, bin->band.height});
            }
    const double middle = 0.5 * (low + high);
    const double half = std::clamp(0.5 * (high - low) + 0.05, 0.5 * kMinRange, 3.0);
    piece.low = std::floor((middle - half) * 10.0) / 10.0;
    piece.high = std::ceil((middle + half) * 10.0) / 10.0;
}

double heightOfPicture(const StripPiece& piece)
{
    return std::ceil(kStripHead + kStripFoot + (piece.high - piece.low) * kStripScale);
}

Shape shapeOf(FeltBy felt)
{
    switch (felt) {
    case FeltBy::Arm: return Shape::Diamond;
    case FeltBy::Contact:
    case FeltBy::Track:
    case FeltBy::Unrecorded: return Shape::Circle;
    case FeltBy::InPart: return Shape::Triangle;
    case FeltBy::Bounded: return Shape::TriangleDown;
    case FeltBy::NotFelt: break;
    }
    return Shape::Square;
}

/// Returns the first and the last column of the strip's newest estimate in a piece. Empty: it holds none of them.
std::optional<std::pair<int, int>> newestColumns(const StripPiece& piece)
{
    std::int64_t newest = 0;
    for (const StripSection& section : piece.strip->sections())
        for (const auto& [index, column] : section.columns)
            for (const auto& bin : column)
                if (bin) newest = std::max(newest, bin->source);
    std::optional<std::pair<int, int>> found;
    for (auto at = piece.section->columns.lower_bound(piece.first);
         at != piece.section->columns.end() && at->first <= piece.last; ++at)
        for (const auto& bin : at->second)
            if (bin && bin->source == newest)
                found =
                    found ? std::pair(found->first, at->first) : std::pair(at->first, at->first);
    return found;
}

bool holdsUnrecorded(const StripPiece& piece)
{
    for (auto at = piece.section->columns.lower_bound(piece.first);
         at != piece.section->columns.end() && at->first <= piece.last; ++at)
        for (const auto& bin : at->second)
            if (bin && bin->felt == FeltBy::Unrecorded) return true;
    return false;
}

/// Style of a side. Left and right differ by line and band as well, for those who see no colours.
struct SideStyle {
    Colour colour;
    bool isRight = false;

    Stroke line() const
    {
        return {{colour.rgb, 0.8}, 1.5, isRight ? std::vector{5.0, 4.0} : std::vector<double>{}};
    }
    void drawBand(Canvas& canvas, Point centre, double top, double bottom) const
    {
        const Point from{centre.x - 4.0, top}, to{centre.x + 4.0, bottom};
        if (!isRight) return canvas.fillRectangle(from, to, {colour.rgb, 0.25});
        canvas.polygon({from, {to.x, from.y}, to, {from.x, to.y}}, {0xffffff, 0.0},
                       {{colour.rgb, 0.6}, 1.0, {}});
    }
};

class StripDrawing {
public:
    StripDrawing(Canvas& canvas, const StripPiece& piece) : canvas_(canvas), piece_(piece) {}

    void draw()
    {
        drawHead();
        drawGrid();
        const std::size_t sides = sidesOf(piece_);
        for (std::size_t side = 0; side < sides; ++side)
            drawSide(side, sides == 1 ? SideStyle{kStripBoth} : sideStyle(side));
        drawLegend(sides);
        drawNewest();
    }

private:
    static SideStyle sideStyle(std::size_t side)
    {
        return side == 0 ? SideStyle{kStripLeftSide} : SideStyle{kStripRightSide, true};
    }

    Point at(double x, double z) const
    {
        return {kStripLeft + (x - kBinWidth * (piece_.first - 0.5)) * kStripScale,
                kStripHead + (piece_.high - z) * kStripScale};
    }

    void drawHead()
    {
        canvas_.text({kStripLeft, 22.0},
                     piece_.wording({TR_NOOP("Report", "Section %1 (%2), %3 to %4 m along the way"),
                                     piece_.number, describe(piece_.section->why),
                                     signedNumber(kBinWidth * piece_.first, 1),
                                     signedNumber(kBinWidth * piece_.last, 1)}),
                     {.colour = kFigureText, .size = 16.0, .bold = true});
        const double right = kStripWidth - kStripRight, left = right - kScaleBar * kStripScale;
        for (const double x : {left, right})
            canvas_.line({x, 12.0}, {x, 24.0}, {kFigureText, 1.5, {}});
        canvas_.line({left, 18.0}, {right, 18.0}, {kFigureText, 1.5, {}});
        canvas_.text({left - 8.0, 23.0}, fmt::format("{:.1f} m", kScaleBar),
                     {.colour = kFigureText, .size = 13.0, .align = Align::Right});
    }

    /// Marks the columns of the newest estimate. All others are remembered.
    void drawNewest()
    {
        const auto columns = newestColumns(piece_);
        if (!columns) return;
        const double y = kStripHead - 8.0;
        const double left = at(kBinWidth * (columns->first - 0.5), 0.0).x;
        const double right = at(kBinWidth * (columns->second + 0.5), 0.0).x;
        canvas_.line({left, y}, {right, y}, {kFigureText, 1.5, {}});
        for (const double x : {left, right})
            canvas_.line({x, y}, {x, y + 8.0}, {kFigureText, 1.5, {}});
        const TextStyle style{.colour = kFigureText, .size = 13.0};
        const std::string text =
            piece_.wording(TR_NOOP("Report", "newest estimate; all else is remembered"));
        const double widest = kStripWidth - kStripRight - canvas_.textWidth(text, style);
        canvas_.text({std::min(left, widest), y - 5.0}, text, style);
    }

    void drawGrid()
    {
        const TextStyle small{.colour = kFigureMuted, .size = 13.0, .align = Align::Right};
        TextStyle below = small;
        below.align = Align::Centre;
        const double left = kBinWidth * (piece_.first - 0.5);
        const double right = kBinWidth * (piece_.last + 0.5);
        const int low = static_cast<int>(std::lround(piece_.low * 10.0));
        const int high = static_cast<int>(std::lround(piece_.high * 10.0));
        const int step = high - low > 20 ? 5 : 2;
        for (int tenth = low; tenth <= high; ++tenth) {
            if (tenth % step != 0) continue;
            const double z = 0.1 * tenth;
            canvas_.line(at(left, z), at(right, z), {kFigureGrid, 1.0, {}});
            canvas_.text({kStripLeft - 8.0, at(left, z).y + 4.0}, signedNumber(z, 1), small);
        }
        for (int column = piece_.first; column <= piece_.last; ++column) {
            if (column % 5 != 0) continue;
            const double x = kBinWidth * column;
            canvas_.line(at(x, piece_.low), at(x, piece_.high), {kFigureGrid, 1.0, {}});
            canvas_.text({at(x, piece_.low).x, at(x, piece_.low).y + 16.0}, signedNumber(x, 1),
                         below);
        }
        canvas_.text({std::max(at(0.5 * (left + right), 0.0).x, kStripLeft + 60.0),
                      at(left, piece_.low).y + kStripFoot - 8.0},
                     piece_.wording(TR_NOOP("Report", "along the way [m]")),
                     {.colour = kFigureMuted, .size = 13.0, .align = Align::Centre});
        canvas_.text({16.0, at(left, 0.5 * (piece_.low + piece_.high)).y},
                     piece_.wording(TR_NOOP("Report", "height [m]")),
                     {.colour = kFigureMuted, .size = 13.0, .align = Align::Centre}, true);
    }

    /// Draws a side: bands, then the line between neighbours, then the marks.
    void drawSide(std::size_t side, const SideStyle& look)
    {
        const double aside = 2.0 * (side == 0 ? -1.0 : 1.0);  // two marks of one bin stay apart
        std::optional<std::pair<int, Point>> before;
        for (auto column = piece_.section->columns.lower_bound(piece_.first);
             column != piece_.section->columns.end() && column->first <= piece_.last; ++column) {
            const std::optional<StripBin>& bin = column->second.at(side);
            if (!bin) continue;
            Point centre = at(kBinWidth * column->first, inRange(bin->band.height));
            centre.x += aside;
            const double top = at(0.0, inRange(bin->band.q90)).y;
            const double bottom = at(0.0, inRange(bin->band.q10)).y;
            look.drawBand(canvas_, centre, top, bottom);
            if (before && before->first + 1 == column->first)
                canvas_.line(before->second, centre, look.line());
            const bool felt = isFelt(bin->felt);
            canvas_.marker(shapeOf(bin->felt), centre, 8.0, felt ? look.colour : Colour{0xffffff},
                           {look.colour, 1.4, {}});
            before = {column->first, centre};
        }
    }

    double inRange(double z) const { return std::clamp(z, piece_.low, piece_.high); }

    void drawLegend(std::size_t sides)
    {
        const Wording& wording = piece_.wording;
        std::vector<KeyEntry> entries;
        const auto mark = [](Shape shape, bool filled) {
            return [shape, filled](Canvas& canvas, Point centre) {
                canvas.marker(shape, centre, 8.0, filled ? kFigureMuted : Colour{0xffffff},
                              {kFigureMuted, 1.4, {}});
            };
        };
        const auto line = [](const SideStyle& look) {
            return [look](Canvas& canvas, Point centre) {
                look.drawBand(canvas, centre, centre.y - 9.0, centre.y + 9.0);
                canvas.line({centre.x - 13.0, centre.y}, {centre.x + 13.0, centre.y}, look.line());
            };
        };
        if (sides == 2) {
            entries.push_back(
                {wording(TR_NOOP("Report", "left, with its 80 % band")), line(sideStyle(0))});
            entries.push_back(
                {wording(TR_NOOP("Report", "right, with its 80 % band")), line(sideStyle(1))});
        } else {
            entries.push_back({wording(TR_NOOP("Report", "both sides alike, with the 80 % band")),
                               line({kStripBoth})});
        }
        entries.push_back(
            {wording(TR_NOOP("Report", "touched by the arm")), mark(Shape::Diamond, true)});
        entries.push_back(
            {wording(TR_NOOP("Report", "felt by flipper or track")), mark(Shape::Circle, true)});
        entries.push_back(
            {wording(TR_NOOP("Report", "felt in part")), mark(Shape::Triangle, false)});
        entries.push_back(
            {wording(TR_NOOP("Report", "bounded")), mark(Shape::TriangleDown, false)});
        entries.push_back({wording(TR_NOOP("Report", "not felt")), mark(Shape::Square, false)});
        if (holdsUnrecorded(piece_))
            entries.push_back(
                {wording(TR_NOOP("Report", "not recorded how")), mark(Shape::Circle, false)});
        drawKey(canvas_, {kStripLeft, 32.0}, kStripWidth - kStripRight, entries);
    }

    Canvas& canvas_;
    const StripPiece& piece_;
};

/// Returns how many later touches of ground lay in the 80 % band said before, by touch.
std::vector<std::pair<std::string, std::string>> ledgerFacts(const StripLedger& ledger,
                                                             const Wording& wording)
{
    constexpr std::array kLabels{TR_NOOP("Report", "80 % bands held at later contacts"),
                                 TR_NOOP("Report", "80 % bands held at later probes"),
                                 TR_NOOP("Report", "80 % bands held at later passes")};
    std::vector<std::pair<std::string, std::string>> facts;
    facts.reserve(kScoredBy.size());
    for (const ScoredBy by : kScoredBy) {
        const StripScore& score = ledger.of(by);
        if (score.n == 0) continue;
        facts.emplace_back(wording(kLabels.at(static_cast<std::size_t>(by))),
                           wording({TR_NOOP("Report", "%1 of %2"), score.in80, score.n}));
    }
    return facts;
}

}  // namespace

std::vector<DocumentPicture> stripPictures(const std::shared_ptr<const Strip>& strip,
                                           std::optional<int> only, const Wording& wording)
{
    const auto columns = static_cast<int>(std::lround(kStripPiece / kBinWidth));
    std::vector<DocumentPicture> pictures;
    for (std::size_t k = 0; k < strip->sections().size(); ++k) {
        if (only && static_cast<std::size_t>(*only) != k + 1) continue;
        const StripSection& section = strip->sections()[k];
        for (auto column = section.columns.begin(); column != section.columns.end();) {
            StripPiece piece{strip, &section, k + 1, column->first, column->first};
            piece.wording = wording;
            for (; column != section.columns.end() && column->first < piece.first + columns;
                 ++column)
                piece.last = column->first;
            setRange(piece);
            pictures.push_back(
                {kStripWidth, heightOfPicture(piece),
                 wording({TR_NOOP("Report", "Ground of section %1 from %2 to %3 m along the way"),
                          piece.number, fixed(kBinWidth * piece.first, 1),
                          fixed(kBinWidth * piece.last, 1)}),
                 [piece](Canvas& canvas) { StripDrawing(canvas, piece).draw(); }});
        }
    }
    return pictures;
}

DocumentPart stripPart(const std::shared_ptr<const Strip>& strip, std::optional<int> only,
                       const Wording& wording)
{
    std::size_t columns = 0, sections = 0;
    for (std::size_t k = 0; k < strip->sections().size(); ++k) {
        if (only && static_cast<std::size_t>(*only) != k + 1) continue;
        columns += strip->sections()[k].columns.size();
        ++sections;
    }
    DocumentPart part{.heading = wording(TR_NOOP("Report", "Strip of felt ground")),
                      .note = {},
                      .facts = {},
                      .pictures = stripPictures(strip, only, wording),
                      .table = {}};
    if (part.pictures.empty())
        part.note =
            wording(TR_NOOP("Report", "No ground is shown: nothing was estimated, or the robot "
                                      "reports no odometry."));
    else
        part.note = wording(
            {TR_NOOP("Report", "Ground: %1 m. Sections: %2. Heights are from the IMU at the "
                               "first scene of a section; both axes have one scale. Bars reach "
                               "from the 0.1 to the 0.9 quantile. At most the last %3 m are "
                               "kept."),
             fixed(kBinWidth * static_cast<double>(columns), 1), sections,
             fixed(kBinWidth * static_cast<double>(StripLimits{}.columns), 0)});
    if (!only) part.facts = ledgerFacts(strip->ledger(), wording);
    return part;
}

Status writeStripPicture(const std::string& path, const std::shared_ptr<const Strip>& strip,
                         const StripText& text, std::optional<int> only, const Wording& wording)
{
    if (path.ends_with(".pdf") || path.ends_with(".html"))
        return writeDocument(path, {text.title, {}, {stripPart(strip, only, wording)}, wording});
    const std::vector<DocumentPicture> pieces = stripPictures(strip, only, wording);
    double height = 0.0;
    std::string words;
    for (const DocumentPicture& piece : pieces) {
        height += piece.height;
        words += piece.text + ". ";
    }
    if (pieces.empty()) return Error{path + ": there is no ground to draw"};
    if (height > kMaxSheet)
        return Error{
            fmt::format("{}: the picture would be {:.0f} px high, expected at most {:.0f}: "
                        "choose one section, or pages (.pdf)",
                        path, height, kMaxSheet)};
    const auto draw = [&](Canvas& canvas) {
        double top = 0.0;
        for (const DocumentPicture& piece : pieces) {
            canvas.place({0.0, top}, 1.0, piece.draw);
            top += piece.height;
        }
    };
    return writePicture(path, static_cast<int>(kStripWidth), static_cast<int>(height), draw,
                        {text.title, words, text.data});
}

}  // namespace terratact
