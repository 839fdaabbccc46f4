#include "app/figures/profile_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "app/figures/canvas.h"
#include "app/figures/figure_colours.h"
#include "core/base/text.h"
#include "core/infer/estimate/provenance.h"
#include "core/infer/verdict/verdict.h"

namespace terratact {
namespace {

constexpr double kPlotLeft = 84.0, kPlotRight = 1170.0, kPlotTop = 84.0, kPlotBottom = 586.0;

constexpr double kProbeRoom = 50.0;  // [px] above all bars for the text "probe here"

constexpr Colour kWhite{0xffffff};
constexpr Colour kSampled{0x12804a}, kContact{0x1558a6}, kArm{0x6a1b9a}, kPrior{0xb06400},
    kWarning{0x8f5200};
constexpr Colour kPriorZone{0xfff4d2}, kTruth{0xd32f2f}, kPrevious{0x7fa8cc};

struct Look {
    Shape shape;
    double size;
    Colour colour;
};

/// Returns the style of the console's mark, with its bar pattern.
Look styleOf(Provenance provenance)
{
    switch (provenance) {
    case Provenance::Arm: return {Shape::Triangle, 16.0, kArm};
    case Provenance::Contact: return {Shape::Square, 13.0, kContact};
    case Provenance::Constrained: return {Shape::TriangleDown, 14.0, kSampled};
    case Provenance::Sampled: return {Shape::Circle, 11.0, kSampled};
    case Provenance::PriorOnly: return {Shape::Diamond, 16.0, kPrior};
    }
    return {};
}

Stroke barStroke(Provenance provenance)
{
    const BarPattern pattern = barPattern(provenance);
    Stroke stroke{styleOf(provenance).colour, pattern.width, pattern.dashes};
    for (double& dash : stroke.dashes) dash *= pattern.width;
    return stroke;
}

/// Equal axes: converts metres to pixels and fits the range into the plot area.
class Axes {
public:
    explicit Axes(const FigureInput& input)
    {
        for (const OutlinePart& part : input.outline)
            for (const auto& [x, z] : part.points) include(x, z);
        includeBars(input.estimate);
        if (input.previous) includeBars(*input.previous);
        if (input.truth)
            for (std::size_t i = 0; i < kBins; ++i)
                include(binCentre(static_cast<int>(i)), (*input.truth)[i]);
        fit(input.proposedBin ? kProbeRoom : 0.0);
    }
    double left() const { return x0_; }
    double right() const { return x1_; }
    double bottom() const { return z0_; }
    double top() const { return z1_; }
    /// Returns the tenths of a metre between two labels.
    int step() const
    {
        const double tenth = 0.1 * scale_;  // [px]
        return tenth > 46.0 ? 1 : 2.0 * tenth > 46.0 ? 2 : 5.0 * tenth > 46.0 ? 5 : 10;
    }
    double x(double metres) const { return kPlotLeft + scale_ * (metres - x0_); }
    double y(double metres) const { return kPlotBottom - scale_ * (metres - z0_); }
    Point at(double xMetres, double zMetres) const { return {x(xMetres), y(zMetres)}; }

private:
    void include(double x, double z)
    {
        constexpr double kAround = 0.05;
        x0_ = std::min(x0_, x - kAround);
        x1_ = std::max(x1_, x + kAround);
        z0_ = std::min(z0_, z - kAround);
        z1_ = std::max(z1_, z + kAround);
    }
    void includeBars(const TerrainEstimate& e)
    {
        for (std::size_t i = 0; i < kBins; ++i) {
            include(binCentre(static_cast<int>(i)), std::min(e.q10[i], e.height[i]));
            include(binCentre(static_cast<int>(i)), std::max(e.q90[i], e.height[i]));
        }
    }
    /// Fits the range into the plot area. room: [px] kept free at the top.
    void fit(double room)
    {
        const double width = kPlotRight - kPlotLeft, height = kPlotBottom - kPlotTop - room;
        scale_ = std::min(width / (x1_ - x0_), height / (z1_ - z0_));
        const double spareX = width / scale_ - (x1_ - x0_), spareZ = height / scale_ - (z1_ - z0_);
        x0_ -= 0.5 * spareX;
        x1_ += 0.5 * spareX;
        z0_ -= 0.5 * spareZ;
        z1_ += 0.5 * spareZ + room / scale_;
    }

    double x0_ = -0.66, x1_ = 0.80, z0_ = -0.42,
           z1_ = 0.20;    // [m] initial range: the robot with extended flippers
    double scale_ = 1.0;  // [px/m]
};

class Drawing {
public:
    Drawing(Canvas& canvas, const FigureInput& input) : canvas_(canvas), input_(input), axes_(input)
    {
    }

    void draw()
    {
        drawHeading();
        drawPriorZones();
        drawGrid();
        drawRobot();
        drawCeilings();
        if (input_.previous) drawPrevious(*input_.previous);
        if (input_.truth) drawLine(*input_.truth, {kTruth, 1.5, {}});
        drawLine(input_.estimate.height, {kSampled, 2.5, {}});
        for (int bin = 0; bin < kBins; ++bin) drawBin(bin);
        drawProbe();
        drawKey();
    }

private:
    std::string wording(const Message& message) const { return input_.wording(message); }
    static double centre(std::size_t i) { return binCentre(static_cast<int>(i)); }

    void drawHeading()
    {
        const TextStyle title{.colour = kFigureText, .size = 21.0, .bold = true};
        canvas_.text({24.0, 36.0}, canvas_.fitted(input_.title, kPlotRight - 24.0, title), title);
        const TerrainEstimate& e = input_.estimate;
        const TextStyle plain{.colour = kFigureMuted, .size = 14.0};
        const std::string how =
            wording({TR_NOOP("Report", "method %1, %2 draws in %3 chains"), name(e.settings.method),
                     e.draws.size(), e.settings.chains});
        canvas_.text({24.0, 62.0}, how, plain);
        if (e.warnings.empty() && e.converged) return;
        const TextStyle warning{.colour = kWarning, .size = 14.0, .bold = true};
        const double from = 24.0 + canvas_.textWidth(how, plain) + 18.0;
        canvas_.text({from, 62.0}, canvas_.fitted(warningText(), kPlotRight - from, warning),
                     warning);
    }

    /// Returns the warnings in one line: the first in full, then the number of others.
    std::string warningText() const
    {
        const auto& warnings = input_.estimate.warnings;
        if (warnings.empty()) return wording(TR_NOOP("Report", "! not converged"));
        if (warnings.size() == 1) return "! " + wording(warnings.front());
        return wording(
            {TR_NOOP("Report", "! (+%1 more) %2"), warnings.size() - 1, warnings.front()});
    }

    void drawPriorZones()
    {
        for (int bin = 0; bin < kBins; ++bin) {
            if (!isUnfeltAhead(input_.estimate, bin) && !input_.estimate.priorOnly(bin)) continue;
            canvas_.fillRectangle({axes_.x(binBegin(bin)), kPlotTop},
                                  {axes_.x(binEnd(bin)), kPlotBottom}, kPriorZone);
        }
    }

    void drawGrid()
    {
        const TextStyle across{.colour = kFigureMuted, .size = 14.0, .align = Align::Centre};
        const TextStyle up{.colour = kFigureMuted, .size = 14.0, .align = Align::Right};
        for (int k = tick(axes_.left(), true); k <= tick(axes_.right(), false); k += axes_.step()) {
            const double x = axes_.x(0.1 * k);
            canvas_.line({x, kPlotTop}, {x, kPlotBottom}, {kFigureGrid, 1.0, {}});
            canvas_.text({x, kPlotBottom + 20.0}, signedNumber(0.1 * k, 1), across);
        }
        for (int k = tick(axes_.bottom(), true); k <= tick(axes_.top(), false); k += axes_.step()) {
            const double y = axes_.y(0.1 * k);
            canvas_.line({kPlotLeft, y}, {kPlotRight, y}, {kFigureGrid, 1.0, {}});
            canvas_.text({kPlotLeft - 8.0, y + 5.0}, signedNumber(0.1 * k, 1), up);
        }
        canvas_.polygon({{kPlotLeft, kPlotTop},
                         {kPlotRight, kPlotTop},
                         {kPlotRight, kPlotBottom},
                         {kPlotLeft, kPlotBottom}},
                        {0xffffff, 0.0}, {kFigureFrame, 1.0, {}});
        canvas_.text({0.5 * (kPlotLeft + kPlotRight), kPlotBottom + 42.0},
                     wording(TR_NOOP("Report", "forward from the IMU [m]")), across);
        canvas_.text({26.0, 0.5 * (kPlotTop + kPlotBottom)},
                     wording(TR_NOOP("Report", "height above the IMU [m]")), across, true);
    }

    /// Returns the first or last label inside the axis, in tenths of a metre.
    int tick(double metres, bool up) const
    {
        const double steps = 10.0 * metres / axes_.step();
        return static_cast<int>(up ? std::ceil(steps) : std::floor(steps)) * axes_.step();
    }

    void drawRobot()
    {
        for (const OutlinePart& part : input_.outline) {
            const bool flipper = part.kind == OutlinePart::Kind::FrontFlipper
                              || part.kind == OutlinePart::Kind::RearFlipper;
            const unsigned rgb = flipper                               ? 0xb6c3d0
                               : part.kind == OutlinePart::Kind::Track ? 0xccd4dc
                                                                       : 0xdde3e9;
            std::vector<Point> points;
            points.reserve(part.points.size());
            for (const auto& [x, z] : part.points) points.push_back(axes_.at(x, z));
            canvas_.polygon(points, {rgb, 0.75}, {{0x6c7a89}, 1.0, {}});
        }
        canvas_.marker(Shape::Circle, axes_.at(0.0, 0.0), 10.0, kFigureText,
                       {kFigureText, 1.0, {}});
    }

    void drawCeilings()
    {
        for (int bin = 0; bin < kBins; ++bin) {
            const double ceiling = input_.estimate.ceiling[static_cast<std::size_t>(bin)];
            if (!std::isfinite(ceiling) || ceiling > axes_.top()) continue;
            canvas_.line(axes_.at(binBegin(bin) + 0.006, ceiling),
                         axes_.at(binEnd(bin) - 0.006, ceiling), {kFigureMuted, 1.6, {2.0, 3.0}});
        }
    }

    void drawLine(const Heights& heights, const Stroke& stroke)
    {
        std::vector<Point> points;
        points.reserve(kBins);
        for (std::size_t i = 0; i < kBins; ++i) points.push_back(axes_.at(centre(i), heights[i]));
        canvas_.polyline(points, stroke);
    }

    void drawBar(double x, double low, double high, double cap, const Stroke& stroke)
    {
        const double top = axes_.y(high), bottom = axes_.y(low);
        canvas_.line({x, top}, {x, bottom}, stroke);
        for (const double y : {top, bottom})
            canvas_.line({x - cap, y}, {x + cap, y}, {stroke.colour, 2.0, {}});
    }

    void drawPrevious(const TerrainEstimate& previous)
    {
        drawLine(previous.mean, {kPrevious, 2.0, {7.0, 4.0}});
        for (std::size_t i = 0; i < kBins; ++i)
            drawBar(axes_.x(centre(i)) - 12.0, previous.q10[i], previous.q90[i], 4.0,
                    {kPrevious, 1.5, {}});
    }

    void drawBin(int bin)
    {
        const auto i = static_cast<std::size_t>(bin);
        const Provenance known = provenance(input_.estimate, bin);
        const Point at = axes_.at(binCentre(bin), input_.estimate.height[i]);
        if (!isUnfeltAhead(input_.estimate, bin))
            drawBar(at.x, input_.estimate.q10[i], input_.estimate.q90[i], 7.0, barStroke(known));
        drawMark(canvas_, styleOf(known), markFill(input_.estimate, bin), at);
    }

    static void drawMark(Canvas& canvas, const Look& look, MarkFill fill, Point at)
    {
        canvas.marker(look.shape, at, look.size, fill == MarkFill::Open ? kWhite : look.colour,
                      {look.colour, 2.0, {}},
                      fill == MarkFill::LowerHalf ? std::optional(kWhite) : std::nullopt);
    }

    /// Draws a dashed line from the plot's top to the bin of the proposed probe.
    void drawProbe()
    {
        if (!input_.proposedBin) return;
        const double x = axes_.x(binCentre(*input_.proposedBin));
        const double down =
            axes_.y(input_.estimate.q90[static_cast<std::size_t>(*input_.proposedBin)]) - 8.0;
        const double from = kPlotTop + 28.0;
        canvas_.text({x, kPlotTop + 21.0}, wording(TR_NOOP("Report", "probe here")),
                     {.colour = kArm, .size = 15.0, .bold = true, .align = Align::Centre});
        if (down - 10.0 > from) canvas_.line({x, from}, {x, down - 8.0}, {kArm, 2.0, {6.0, 4.0}});
        const double tip = std::max(down, from + 10.0);
        canvas_.polygon({{x - 6.0, tip - 10.0}, {x + 6.0, tip - 10.0}, {x, tip}}, kArm,
                        {kArm, 1.0, {}});
    }

    void drawKey()
    {
        std::vector<KeyEntry> entries;
        for (const Provenance known : kProvenances) {
            if (!present(known)) continue;
            entries.push_back(
                {wording(tableWord(name(known))), [known](Canvas& canvas, Point at) {
                     const Look look = styleOf(known);
                     const bool open = known == Provenance::PriorOnly;
                     if (open)
                         canvas.fillRectangle({at.x - 15.0, at.y - 11.0},
                                              {at.x + 15.0, at.y + 11.0}, kPriorZone);
                     canvas.line({at.x - 15.0, at.y}, {at.x + 15.0, at.y}, barStroke(known));
                     drawMark(canvas, look, open ? MarkFill::Open : MarkFill::Full, at);
                 }});
        }
        entries.push_back(
            {wording(TR_NOOP("Report", "open: not felt")), [](Canvas& canvas, Point at) {
                 drawMark(canvas, styleOf(Provenance::Sampled), MarkFill::Open, at);
             }});
        addLine(entries, wording(TR_NOOP("Report", "mean")), {kSampled, 2.5, {}});
        entries.push_back(
            {wording(TR_NOOP("Report", "0.1 to 0.9 quantile")), [](Canvas& canvas, Point at) {
                 canvas.line({at.x, at.y - 9.0}, {at.x, at.y + 9.0}, {kSampled, 2.0, {}});
                 for (const double dy : {-9.0, 9.0})
                     canvas.line({at.x - 6.0, at.y + dy}, {at.x + 6.0, at.y + dy},
                                 {kSampled, 2.0, {}});
             }});
        addLine(entries, wording(TR_NOOP("Report", "ceiling by the body")),
                {kFigureMuted, 1.6, {2.0, 3.0}});
        if (input_.previous)
            addLine(entries, wording(TR_NOOP("Report", "estimate before")),
                    {kPrevious, 2.0, {7.0, 4.0}});
        if (input_.truth) addLine(entries, wording(TR_NOOP("Report", "truth")), {kTruth, 1.5, {}});
        entries.push_back(
            {"IMU", [](Canvas& canvas, Point at) {
                 canvas.marker(Shape::Circle, at, 10.0, kFigureText, {kFigureText, 1.0, {}});
             }});
        terratact::drawKey(canvas_, {kPlotLeft, kPlotBottom + 54.0}, kPlotRight, entries);
    }

    static void addLine(std::vector<KeyEntry>& entries, std::string words, const Stroke& stroke)
    {
        entries.push_back({std::move(words), [stroke](Canvas& canvas, Point at) {
                               canvas.line({at.x - 14.0, at.y}, {at.x + 14.0, at.y}, stroke);
                           }});
    }

    bool present(Provenance known) const
    {
        for (int bin = 0; bin < kBins; ++bin)
            if (provenance(input_.estimate, bin) == known) return true;
        return false;
    }

    Canvas& canvas_;
    const FigureInput& input_;
    Axes axes_;
};

}  // namespace

Status writeProfileFigure(const std::string& path, const FigureInput& input,
                          const FileWriter& write)
{
    return writePicture(
        path, kProfileWidth, kProfileHeight, [&](Canvas& canvas) { drawProfile(canvas, input); },
        {}, write);
}

void drawProfile(Canvas& canvas, const FigureInput& input)
{
    Drawing(canvas, input).draw();
}

std::string profileTable(const TerrainEstimate& estimate, const std::optional<Heights>& truth)
{
    // Only Markov chains have R-hat and effective draws.
    const bool chains = estimate.ending != Ending::NotSampled;
    std::string table =
        "   bin  height    sd    80 % band        ceiling  source       touch       ";
    if (chains) table += "   R-hat    ESS";
    const std::string units = "    [m]     [m]  [mm]          [m]            [m]";
    const std::string gap(table.size() - units.size(), ' ');
    table += truth ? "    truth  error\n" : "\n";
    table += units;
    table += truth ? gap + "      [m]   [mm]\n" : "\n";
    auto out = std::back_inserter(table);
    for (std::size_t i = 0; i < kBins; ++i) {
        const int bin = static_cast<int>(i);
        const std::string ceiling =
            std::isfinite(estimate.ceiling[i]) ? fmt::format("{:+.3f}", estimate.ceiling[i]) : "-";
        fmt::format_to(out, "  {:+.1f}  {:+.3f}  {:4.0f}  {:+.3f} … {:+.3f}  {:>8}  {:<11}  {:<12}",
                       binCentre(bin), estimate.height[i], 1000.0 * estimate.sd[i], estimate.q10[i],
                       estimate.q90[i], ceiling, name(provenance(estimate, bin)),
                       name(estimate.touch[i]));
        if (chains)
            fmt::format_to(out, " {:>7} {:6.0f}", rhatText(estimate.rhat[i]), estimate.ess[i]);
        if (truth)
            fmt::format_to(out, "   {:+.3f}  {:+5.0f}", (*truth)[i],
                           1000.0 * (estimate.height[i] - (*truth)[i]));
        table += '\n';
    }
    return table;
}

}  // namespace terratact
