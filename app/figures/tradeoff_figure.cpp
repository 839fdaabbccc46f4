#include "app/figures/tradeoff_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "app/figures/canvas.h"
#include "app/figures/figure_colours.h"
#include "app/figures/method_style.h"

namespace terratact {
namespace {

constexpr int kTradeoffWidth = 1800, kTradeoffHeight = 760;
constexpr double kTradeoffTop = 110.0, kTradeoffBottom = 620.0, kPanelWidth = 760.0,
                 kFirstLeft = 96.0, kSecondLeft = 990.0;
constexpr Colour kFront{0x16222e, 0.55};

constexpr double kMin = 1e-9, kMax = 1e9;  // range of the scales

/// Returns 1, 2 or 5 times a power of ten: the value `step` steps above 1.
double oneTwoFive(int step)
{
    const int decade = step >= 0 ? step / 3 : (step - 2) / 3;
    constexpr double kDigits[]{1.0, 2.0, 5.0};
    return kDigits[step - 3 * decade] * std::pow(10.0, decade);
}

/// A logarithmic scale between two values of 1, 2, 5. The value 0 is drawn at its start.
class LogScale {
public:
    LogScale(const std::vector<double>& values, double from, double to) : from_(from), to_(to)
    {
        double least = kMax, most = kMin;
        for (const double value : values) {
            if (value > 0.0) least = std::min(least, std::max(value, kMin));
            most = std::max(most, std::min(value, kMax));
        }
        least = std::min(least, most);
        first_ = static_cast<int>(std::floor(3.0 * std::log10(least))) - 1;
        while (oneTwoFive(first_ + 1) <= least * (1.0 + 1e-9)) ++first_;
        last_ = first_ + 1;
        while (oneTwoFive(last_) < most * (1.0 - 1e-9)) ++last_;
    }
    double operator()(double value) const
    {
        const double first = std::log10(oneTwoFive(first_)), last = std::log10(oneTwoFive(last_));
        const double share = (std::log10(std::max(value, kMin)) - first) / (last - first);
        return from_ + (to_ - from_) * std::clamp(share, 0.0, 1.0);
    }
    std::vector<double> ticks() const
    {
        std::vector<double> all;
        for (int step = first_; step <= last_; ++step) all.push_back(oneTwoFive(step));
        return all;
    }

private:
    double from_, to_;
    int first_ = 0, last_ = 1;
};

struct Series {
    std::vector<double> cost;   ///< [ms]
    std::vector<double> error;  ///< [mm]
};

/// One panel: its scales and its points.
class Panel {
public:
    Panel(Canvas& canvas, double left, Series series)
        : canvas_(canvas), left_(left), series_(std::move(series)),
          x_(series_.cost, left, left + kPanelWidth),
          y_(series_.error, kTradeoffBottom, kTradeoffTop)
    {
    }

    void axes(std::string_view title)
    {
        const TextStyle right{.colour = kFigureMuted, .size = 13.0, .align = Align::Right};
        const TextStyle centre{.colour = kFigureMuted, .size = 13.0, .align = Align::Centre};
        for (const double tick : x_.ticks()) {
            canvas_.line({x_(tick), kTradeoffTop}, {x_(tick), kTradeoffBottom},
                         {kFigureGrid, 1.0, {}});
            canvas_.text({x_(tick), kTradeoffBottom + 20.0}, fmt::format("{:g}", tick), centre);
        }
        for (const double tick : y_.ticks()) {
            canvas_.line({left_, y_(tick)}, {left_ + kPanelWidth, y_(tick)},
                         {kFigureGrid, 1.0, {}});
            canvas_.text({left_ - 8.0, y_(tick) + 5.0}, fmt::format("{:g}", tick), right);
        }
        canvas_.text({left_, kTradeoffTop - 14.0}, title,
                     {.colour = kFigureText, .size = 15.0, .bold = true});
        canvas_.text({left_ + 0.5 * kPanelWidth, kTradeoffBottom + 44.0},
                     "time per scene, one core [ms]", centre);
        canvas_.text({left_ - 62.0, 0.5 * (kTradeoffTop + kTradeoffBottom)}, "[mm]", centre, true);
    }

    /// Draws the front through the points on it.
    void front(const std::vector<bool>& on, Colour colour)
    {
        std::vector<Point> line;
        for (std::size_t k = 0; k < on.size(); ++k)
            if (on[k]) line.push_back(at(k));
        std::sort(line.begin(), line.end(),
                  [](const Point& a, const Point& b) { return a.x < b.x; });
        if (line.size() > 1) canvas_.polyline(line, {colour, 2.0, {6.0, 4.0}});
    }

    void points(std::span<const TradePoint> all)
    {
        for (std::size_t k = 0; k < all.size(); ++k) {
            const TradeSetting& setting = all[k].setting;
            const MethodStyle look = styleOf(setting.settings.method);
            drawMarker(canvas_, look, at(k), setting.preset ? 1.3 : 0.75);
            if (setting.preset)
                canvas_.text({at(k).x + 10.0, at(k).y - 9.0}, setting.varied,
                             {.colour = look.colour, .size = 13.0, .bold = true});
        }
    }

private:
    Point at(std::size_t k) const { return {x_(series_.cost[k]), y_(series_.error[k])}; }

    Canvas& canvas_;
    double left_;
    Series series_;
    LogScale x_, y_;
};

void draw(Canvas& canvas, std::span<const TradePoint> points)
{
    Series reference, truth;
    std::vector<Method> methods;
    for (const TradePoint& p : points) {
        reference.cost.push_back(1e3 * p.seconds);
        reference.error.push_back(1e3 * p.reference.quantile);
        truth.error.push_back(1e3 * p.error);
        const Method method = p.setting.settings.method;
        if (std::find(methods.begin(), methods.end(), method) == methods.end())
            methods.push_back(method);
    }
    truth.cost = reference.cost;
    canvas.text({24.0, 36.0}, "Time and accuracy",
                {.colour = kFigureText, .size = 21.0, .bold = true});
    canvas.text({24.0, 62.0},
                "every marker is one setting; large and named: the presets; dashed: Pareto fronts, "
                "on the left of each method, "
                "whose own long run that is; closed forms are exact there: 0, at the bottom",
                {.colour = kFigureMuted, .size = 14.0});
    Panel left(canvas, kFirstLeft, std::move(reference));
    Panel right(canvas, kSecondLeft, std::move(truth));
    left.axes("distance of the 0.1 and 0.9 quantiles from a long run");
    right.axes("mean |height − truth|");
    const TradeFronts fronts = tradeFronts(points);
    for (const Method method : methods) {
        std::vector<bool> own = fronts.reference;
        for (std::size_t k = 0; k < own.size(); ++k)
            if (points[k].setting.settings.method != method) own[k] = false;
        left.front(own, styleOf(method).colour);
    }
    right.front(fronts.truth, kFront);
    left.points(points);
    right.points(points);
    std::vector<KeyEntry> entries;
    entries.reserve(methods.size());
    for (const Method method : methods)
        entries.push_back({styleOf(method).words, [look = styleOf(method)](Canvas& c, Point at) {
                               drawMarker(c, look, at, 1.0);
                           }});
    drawKey(canvas, {kFirstLeft, kTradeoffBottom + 68.0}, kSecondLeft + kPanelWidth, entries);
}

}  // namespace

Status writeTradeoffFigure(const std::string& path, std::span<const TradePoint> points,
                           const FileWriter& write)
{
    if (points.empty()) throw std::invalid_argument("writeTradeoffFigure: no points");
    return writePicture(
        path, kTradeoffWidth, kTradeoffHeight, [&](Canvas& canvas) { draw(canvas, points); }, {},
        write);
}

}  // namespace terratact
