#include "app/figures/truth_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/figures/canvas.h"
#include "app/figures/figure_colours.h"
#include "app/modelling/truth/truth_slice.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {
namespace {

constexpr double kTileWidth = 430.0, kTileHeight = 330.0, kSheetHead = 84.0;
constexpr std::size_t kTileColumns = 4;
constexpr double kTileScale = 240.0;  // [px/m]
constexpr Colour kLeftSlice{0x1558a6}, kRightSlice{0xb06400}, kBothSides{0x12804a},
    kGapText{0xa32020};

Colour lineColour(TruthLine line)
{
    return sideOf(line) == Side::Left ? kLeftSlice : kRightSlice;
}

const char* gapText(TruthGap gap)
{
    switch (gap) {
    case TruthGap::None: return "";
    case TruthGap::OtherRun: return "another run";
    case TruthGap::NoPose: return "no pose";
    case TruthGap::OffCloud: return "left out: the robot lies off the cloud";
    case TruthGap::NoCloud: return "no bin is known well enough";
    case TruthGap::Excluded: return "excluded by decision";
    }
    return "";
}

/// Draws one scene in a tile whose top left corner is the canvas's origin.
class TruthTile {
public:
    TruthTile(Canvas& canvas, const LaserTruth& truth, std::size_t row)
        : canvas_(canvas), truth_(truth), row_(row), scene_(truth.truths[row])
    {
    }

    void draw()
    {
        drawGrid();
        drawRobot();
        drawSlice();
        if (truth_.isPlane) {
            drawBins(scene_.plane, kBothSides, 0.0);
        } else {
            drawBins(scene_.side[0], kLeftSlice, -2.0);
            drawBins(scene_.side[1], kRightSlice, 2.0);
        }
        drawHead();
    }

private:
    static Point at(double x, double z)
    {
        return {(x - kSliceRear) * kTileScale, 26.0 + (kSliceTop - z) * kTileScale};
    }
    static bool isInside(double z) { return z < kSliceTop && z > kSliceBottom; }

    void drawGrid()
    {
        const TextStyle small{.colour = kFigureMuted, .size = 10.0};
        for (int tenth = -8; tenth <= 8; tenth += 2) {
            const double x = 0.1 * tenth;
            canvas_.line(at(x, kSliceTop), at(x, kSliceBottom), {kFigureGrid, 1.0, {}});
            const Point foot = at(x, kSliceBottom);
            canvas_.text({foot.x - 8.0, foot.y + 11.0}, signedNumber(x, 1), small);
        }
        for (int tenth = -8; tenth <= 2; tenth += 2) {
            const double z = 0.1 * tenth;
            canvas_.line(at(kSliceRear, z), at(kSliceFront, z), {kFigureGrid, 1.0, {}});
            canvas_.text({2.0, at(kSliceRear, z).y - 2.0}, signedNumber(z, 1), small);
        }
    }

    void drawRobot()
    {
        const auto& f = truth_.grid->places()[scene_.place].s.flippers;
        for (const OutlinePart& part : robotOutline(truth_.robot, truth_.tracks[row_].s.pitch,
                                                    0.5 * (f[0] + f[1]), 0.5 * (f[2] + f[3]))) {
            std::vector<Point> points;
            points.reserve(part.points.size());
            for (const auto& [x, z] : part.points) points.push_back(at(x, z));
            canvas_.polygon(points, {0xdde3e9, 0.7}, {{0x6c7a89}, 1.0, {}});
        }
    }

    void drawSlice()
    {
        for (const SlicePoint& point : truthSlice(truth_, row_)) {
            const Point p = at(point.x, point.z);
            canvas_.fillRectangle({p.x - 0.8, p.y - 0.8}, {p.x + 0.8, p.y + 0.8},
                                  {lineColour(point.line).rgb, 0.35});
        }
    }

    void drawBins(const SideTruth& bins, Colour colour, double shift)
    {
        for (int i = 0; i < kBins; ++i) {
            const BinTruth& bin = bins.at(static_cast<std::size_t>(i));
            if (!bin.height || !isInside(*bin.height)) continue;
            canvas_.line(at(binBegin(i) + 0.008, *bin.height), at(binEnd(i) - 0.008, *bin.height),
                         {colour, 2.5, {}});
            Point low = at(binCentre(i), *bin.height - 2.0 * bin.sd),
                  high = at(binCentre(i), *bin.height + 2.0 * bin.sd);
            low.x += shift;
            high.x += shift;
            canvas_.line(low, high, {colour, 1.5, {}});
        }
    }

    void drawHead()
    {
        const TextStyle title{.colour = kFigureText, .size = 13.0, .bold = true};
        std::string text = fmt::format("row {}, run {}, {:.1f} s", row_ + 1, truth_.runOf(row_),
                                       truth_.timeOf(row_));
        if (scene_.contact)
            text += fmt::format(", cloud {:+.0f} mm", -1e3 * scene_.contact->offset);
        canvas_.text({4.0, 18.0}, canvas_.fitted(text, kTileWidth - 12.0, title), title);
        if (scene_.gap != TruthGap::None)
            canvas_.text({8.0, 44.0}, gapText(scene_.gap),
                         {.colour = kGapText, .size = 13.0, .bold = true});
    }

    Canvas& canvas_;
    const LaserTruth& truth_;
    std::size_t row_;
    const SceneTruth& scene_;
};

std::vector<std::size_t> rowsOfSheet(const LaserTruth& truth)
{
    std::vector<std::size_t> placed;
    for (std::size_t row = 0; row < truth.scenes(); ++row)
        if (truth.truths[row].gap != TruthGap::OtherRun
            && truth.truths[row].gap != TruthGap::NoPose)
            placed.push_back(row);
    if (placed.size() <= kMaxSheetScenes) return placed;
    std::vector<std::size_t> chosen;
    chosen.reserve(kMaxSheetScenes);
    for (std::size_t i = 0; i < kMaxSheetScenes; ++i)
        chosen.push_back(placed[i * placed.size() / kMaxSheetScenes]);
    return chosen;
}

void drawSheetHead(Canvas& canvas, const LaserTruth& truth, std::size_t shown)
{
    canvas.text({12.0, 30.0},
                fmt::format("{} of {} scenes: cloud, robot and bins, heights above the IMU [m]",
                            shown, truth.scenes()),
                {.colour = kFigureText, .size = 20.0, .bold = true});
    std::vector<KeyEntry> entries;
    const auto add = [&](const char* words, Colour colour) {
        entries.push_back({words, [colour](Canvas& c, Point p) {
                               c.line({p.x - 12.0, p.y}, {p.x + 12.0, p.y}, {colour, 3.0, {}});
                           }});
    };
    add("points and bins, left", kLeftSlice);
    add("right", kRightSlice);
    if (truth.isPlane) add("bins, both sides", kBothSides);
    entries.push_back({"two sd", [](Canvas& c, Point p) {
                           c.line({p.x, p.y - 9.0}, {p.x, p.y + 9.0}, {kFigureMuted, 1.5, {}});
                       }});
    drawKey(canvas, {12.0, 46.0}, kTileColumns * kTileWidth - 12.0, entries);
}

}  // namespace

Status writeTruthSheet(const std::string& path, const LaserTruth& truth, const FileWriter& write)
{
    const std::vector<std::size_t> rows = rowsOfSheet(truth);
    const std::size_t lines = (rows.size() + kTileColumns - 1) / kTileColumns;
    return writePicture(
        path, static_cast<int>(kTileColumns * kTileWidth),
        static_cast<int>(kSheetHead + static_cast<double>(lines) * kTileHeight),
        [&](Canvas& canvas) {
            drawSheetHead(canvas, truth, rows.size());
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const std::size_t column = i % kTileColumns, line = i / kTileColumns;
                canvas.place({static_cast<double>(column) * kTileWidth,
                              kSheetHead + static_cast<double>(line) * kTileHeight},
                             1.0, [&](Canvas& tile) { TruthTile(tile, truth, rows[i]).draw(); });
            }
        },
        {}, write);
}

}  // namespace terratact
