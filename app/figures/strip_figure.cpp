#include "app/figures/strip_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/figures/canvas.h"
#include "app/figures/figure_colours.h"
#include "core/terrain/bins.h"

namespace terratact {
namespace {

constexpr double kStripWidth = 1200.0, kStripLeft = 70.0, kStripRight = 20.0;
constexpr double kStripHead = 64.0, kStripFoot = 42.0;
constexpr double kStripScale = (kStripWidth - kStripLeft - kStripRight) / kStripPiece;  // [px/m]
constexpr double kLeastRange = 0.4;                                                     // [m]
constexpr Colour kStripLeftSide{0x1558a6}, kStripRightSide{0xb06400}, kStripBoth{0x12804a};

/// Piece of a section between two columns.
struct StripPiece {
    std::shared_ptr<const Strip> strip;
    const StripSection* section = nullptr;
    std::size_t number = 0;        ///< of the section, from 1
    int first = 0, last = 0;       ///< columns
    double low = 0.0, high = 0.0;  ///< [m] range of heights
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
    const double half = std::clamp(0.5 * (high - low) + 0.05, 0.5 * kLeastRange, 3.0);
    piece.low = std::floor((middle - half) * 10.0) / 10.0;
    piece.high = std::ceil((middle + half) * 10.0) / 10.0;
}

double heightOfPicture(const StripPiece& piece)
{
    return std::ceil(kStripHead + kStripFoot + (piece.high - piece.low) * kStripScale);
}

Shape shapeOf(FeltBy felt)
{
    if (isFelt(felt)) return felt == FeltBy::Arm ? Shape::Diamond : Shape::Circle;
    return felt == FeltBy::Bounded ? Shape::TriangleDown : Shape::Square;
}

class StripDrawing {
public:
    StripDrawing(Canvas& canvas, const StripPiece& piece) : canvas_(canvas), piece_(piece) {}

    void draw()
    {
        drawHead();
        drawGrid();
        const std::size_t sides = sidesOf(piece_);
        for (std::size_t side = 0; side < sides; ++side)
            drawSide(side, sides == 1 ? kStripBoth : side == 0 ? kStripLeftSide : kStripRightSide);
        drawLegend(sides);
    }

private:
    Point at(double x, double z) const
    {
        return {kStripLeft + (x - kBinWidth * (piece_.first - 0.5)) * kStripScale,
                kStripHead + (piece_.high - z) * kStripScale};
    }

    void drawHead()
    {
        canvas_.text({kStripLeft, 22.0},
                     fmt::format("Section {} ({}), {} to {} m along the way", piece_.number,
                                 name(piece_.section->why),
                                 signedNumber(kBinWidth * piece_.first, 1),
                                 signedNumber(kBinWidth * piece_.last, 1)),
                     {.colour = kFigureText, .size = 16.0, .bold = true});
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
        canvas_.text({16.0, at(left, 0.5 * (piece_.low + piece_.high)).y}, "height [m]",
                     {.colour = kFigureMuted, .size = 13.0, .align = Align::Centre}, true);
    }

    /// Draws a side: bands, then the line between neighbours, then the marks.
    void drawSide(std::size_t side, Colour colour)
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
            canvas_.fillRectangle({centre.x - 4.0, top}, {centre.x + 4.0, bottom},
                                  {colour.rgb, 0.25});
            if (before && before->first + 1 == column->first)
                canvas_.line(before->second, centre, {{colour.rgb, 0.7}, 1.5, {}});
            const bool felt = isFelt(bin->felt);
            canvas_.marker(shapeOf(bin->felt), centre, 8.0, felt ? colour : Colour{0xffffff},
                           {colour, 1.4, {}});
            before = {column->first, centre};
        }
    }

    double inRange(double z) const { return std::clamp(z, piece_.low, piece_.high); }

    void drawLegend(std::size_t sides)
    {
        std::vector<KeyEntry> entries;
        const auto mark = [](Shape shape, bool filled) {
            return [shape, filled](Canvas& canvas, Point centre) {
                canvas.marker(shape, centre, 8.0, filled ? kFigureMuted : Colour{0xffffff},
                              {kFigureMuted, 1.4, {}});
            };
        };
        const auto line = [](Colour colour) {
            return [colour](Canvas& canvas, Point centre) {
                canvas.line({centre.x - 13.0, centre.y}, {centre.x + 13.0, centre.y},
                            {colour, 3.0, {}});
            };
        };
        if (sides == 2) {
            entries.push_back({"left", line(kStripLeftSide)});
            entries.push_back({"right", line(kStripRightSide)});
        } else {
            entries.push_back({"both sides alike", line(kStripBoth)});
        }
        entries.push_back({"touched by the arm", mark(Shape::Diamond, true)});
        entries.push_back({"felt by flipper or track", mark(Shape::Circle, true)});
        entries.push_back({"bounded", mark(Shape::TriangleDown, false)});
        entries.push_back({"not felt, or in part", mark(Shape::Square, false)});
        drawKey(canvas_, {kStripLeft, 32.0}, kStripWidth - kStripRight, entries);
    }

    Canvas& canvas_;
    const StripPiece& piece_;
};

}  // namespace

std::vector<DocumentPicture> stripPictures(const std::shared_ptr<const Strip>& strip)
{
    const auto columns = static_cast<int>(std::lround(kStripPiece / kBinWidth));
    std::vector<DocumentPicture> pictures;
    for (std::size_t k = 0; k < strip->sections().size(); ++k) {
        const StripSection& section = strip->sections()[k];
        for (auto column = section.columns.begin(); column != section.columns.end();) {
            StripPiece piece{strip, &section, k + 1, column->first, column->first};
            for (; column != section.columns.end() && column->first < piece.first + columns;
                 ++column)
                piece.last = column->first;
            setRange(piece);
            pictures.push_back(
                {kStripWidth, heightOfPicture(piece),
                 fmt::format("Ground of section {} from {:.1f} to {:.1f} m along the way",
                             piece.number, kBinWidth * piece.first, kBinWidth * piece.last),
                 [piece](Canvas& canvas) { StripDrawing(canvas, piece).draw(); }});
        }
    }
    return pictures;
}

}  // namespace terratact
