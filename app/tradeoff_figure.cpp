#include "app/tradeoff_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "app/canvas.h"
#include "app/figure_colours.h"
#include "app/method_look.h"

namespace terratact {
namespace {

constexpr int kWidth = 1800, kHeight = 760;
constexpr double kTop = 110.0, kBottom = 620.0, kPanelWidth = 760.0, kFirstLeft = 96.0,
                 kSecondLeft = 990.0;
constexpr Colour kFront{0x16222e, 0.55};

/// A logarithmic scale over whole decades.
class LogScale {
public:
    LogScale(const std::vector<double>& values, double from, double to) : from_(from), to_(to)
    {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        first_ = static_cast<int>(std::floor(std::log10(std::max(*least, 1e-9))));
        last_ =
            std::max(first_ + 1, static_cast<int>(std::ceil(std::log10(std::max(*most, 1e-9)))));
    }
    double operator()(double value) const
    {
        const double decades = std::log10(std::max(value, 1e-9)) - first_;
        return from_ + (to_ - from_) * std::max(decades, 0.0) / (last_ - first_);
    }
    /// 1, 2, 5 of every decade.
    std::vector<double> ticks() const
    {
        std::vector<double> all;
        for (int decade = first_; decade <= last_; ++decade)
            for (const double digit : {1.0, 2.0, 5.0})
                if (decade < last_ || digit == 1.0) all.push_back(digit * std::pow(10.0, decade));
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

/// One panel: where its points lie, and what it shows.
class Panel {
public:
    Panel(Canvas& canvas, double left, Series series)
        : canvas_(canvas), left_(left), series_(std::move(series)),
          x_(series_.cost, left, left + kPanelWidth), y_(series_.error, kBottom, kTop)
    {
    }

    void axes(std::string_view title)
    {
        const TextStyle right{.colour = kFigureMuted, .size = 13.0, .align = Align::Right};
        const TextStyle centre{.colour = kFigureMuted, .size = 13.0, .align = Align::Centre};
        for (const double tick : x_.ticks()) {
            canvas_.line({x_(tick), kTop}, {x_(tick), kBottom}, {kFigureGrid, 1.0, {}});
            canvas_.text({x_(tick), kBottom + 20.0}, fmt::format("{:g}", tick), centre);
        }
        for (const double tick : y_.ticks()) {
            canvas_.line({left_, y_(tick)}, {left_ + kPanelWidth, y_(tick)},
                         {kFigureGrid, 1.0, {}});
            canvas_.text({left_ - 8.0, y_(tick) + 5.0}, fmt::format("{:g}", tick), right);
        }
        canvas_.text({left_, kTop - 14.0}, title,
                     {.colour = kFigureText, .size = 15.0, .bold = true});
        canvas_.text({left_ + 0.5 * kPanelWidth, kBottom + 44.0}, "time per scene, one core [ms]",
                     centre);
        canvas_.text({left_ - 62.0, 0.5 * (kTop + kBottom)}, "[mm]", centre, true);
    }

    void front()
    {
        const std::vector<bool> on = paretoFront(series_.cost, series_.error);
        std::vector<Point> line;
        for (std::size_t k = 0; k < on.size(); ++k)
            if (on[k]) line.push_back(at(k));
        std::sort(line.begin(), line.end(),
                  [](const Point& a, const Point& b) { return a.x < b.x; });
        canvas_.polyline(line, {kFront, 2.0, {6.0, 4.0}});
    }

    void points(std::span<const TradePoint> all)
    {
        for (std::size_t k = 0; k < all.size(); ++k) {
            const TradeSetting& setting = all[k].setting;
            const MethodLook look = lookOf(setting.settings.method);
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
    canvas.text(
        {24.0, 62.0},
        "every marker is one setting; large and named: the presets; dashed: the Pareto front",
        {.colour = kFigureMuted, .size = 14.0});
    Panel left(canvas, kFirstLeft, std::move(reference));
    Panel right(canvas, kSecondLeft, std::move(truth));
    left.axes("distance of the 0.1 and 0.9 quantiles from a long run");
    right.axes("mean |height − truth|");
    for (Panel* panel : {&left, &right}) {
        panel->front();
        panel->points(points);
    }
    std::vector<KeyEntry> entries;
    entries.reserve(methods.size());
    for (const Method method : methods)
        entries.push_back({lookOf(method).words, [look = lookOf(method)](Canvas& c, Point at) {
                               drawMarker(c, look, at, 1.0);
                           }});
    drawKey(canvas, {kFirstLeft, kBottom + 68.0}, kSecondLeft + kPanelWidth, entries);
}

}  // namespace

Status writeTradeoffFigure(const std::string& path, std::span<const TradePoint> points)
{
    if (points.empty()) throw std::invalid_argument("writeTradeoffFigure: no points");
    return writePicture(path, kWidth, kHeight, [&](Canvas& canvas) { draw(canvas, points); });
}

}  // namespace terratact
