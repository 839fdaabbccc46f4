#include "app/figures/evaluation_figure.h"

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

constexpr int kWidth = 1200, kWideWidth = 1800, kHeight = 700;
constexpr std::size_t kFewSeries = 5;
constexpr double kLeft = 84.0, kMargin = 30.0, kTop = 84.0, kBottom = 590.0;
int widthFor(std::size_t series)
{
    return series > kFewSeries ? kWideWidth : kWidth;
}

/// Returns 1, 2 or 5 times a power of ten, with at most eight steps up to `top`.
double niceStep(double top)
{
    const double power = std::pow(10.0, std::floor(std::log10(top / 8.0)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power * 8.0 >= top) return factor * power;
    return 10.0 * power;
}

/// A bar chart: classes along x, values from 0 along y.
class Chart {
public:
    Chart(Canvas& canvas, std::size_t classes, std::size_t series, double top)
        : canvas_(canvas), classes_(classes), step_(niceStep(top)),
          right_(widthFor(series) - kMargin)
    {
        top_ = step_ * std::ceil(top / step_);
    }
    double right() const { return right_; }
    double y(double value) const { return kBottom - (kBottom - kTop) * value / top_; }
    double classWidth() const { return (right_ - kLeft) / static_cast<double>(classes_); }
    double classBegin(std::size_t k) const { return kLeft + classWidth() * static_cast<double>(k); }

    void heading(std::string_view title, std::string_view subtitle)
    {
        canvas_.text({24.0, 36.0}, title, {.colour = kFigureText, .size = 21.0, .bold = true});
        canvas_.text({24.0, 62.0}, subtitle, {.colour = kFigureMuted, .size = 14.0});
    }

    void axes(std::string_view across, std::string_view up)
    {
        const TextStyle right{.colour = kFigureMuted, .size = 14.0, .align = Align::Right};
        const TextStyle centre{.colour = kFigureMuted, .size = 14.0, .align = Align::Centre};
        for (int k = 0; k * step_ <= top_ * (1.0 + 1e-9); ++k) {
            canvas_.line({kLeft, y(k * step_)}, {right_, y(k * step_)},
                         {k == 0 ? kFigureFrame : kFigureGrid, 1.0, {}});
            canvas_.text({kLeft - 8.0, y(k * step_) + 5.0}, fmt::format("{:g}", k * step_), right);
        }
        canvas_.text({0.5 * (kLeft + right_), kBottom + 44.0}, across, centre);
        canvas_.text({26.0, 0.5 * (kTop + kBottom)}, up, centre, true);
    }

    void labelClass(double x, std::string_view words)
    {
        canvas_.text({x, kBottom + 20.0}, words,
                     {.colour = kFigureMuted, .size = 14.0, .align = Align::Centre});
    }

    void key(const std::vector<std::string>& labels, bool bars)
    {
        std::vector<KeyEntry> entries;
        for (const std::string& label : labels) {
            const MethodStyle look = styleOf(label);
            entries.push_back({look.words, [look, bars](Canvas& canvas, Point at) {
                                   if (bars)
                                       canvas.fillRectangle({at.x - 12.0, at.y - 7.0},
                                                            {at.x + 12.0, at.y + 7.0}, look.colour);
                                   else
                                       drawMarker(canvas, look, at, 1.0);
                               }});
        }
        drawKey(canvas_, {kLeft, kBottom + 58.0}, right_, entries);
    }

private:
    Canvas& canvas_;
    std::size_t classes_;
    double step_;
    double right_;
    double top_ = 1.0;
};

double percentOf(const ErrorHistogram& h, std::size_t k)
{
    return 100.0 * static_cast<double>(h.count[k]) / static_cast<double>(h.n);
}

void drawHistograms(Canvas& canvas, std::span<const ErrorHistogram> histograms)
{
    const std::size_t classes = histograms.front().count.size();
    double top = 1.0;
    std::vector<std::string> labels;
    for (const ErrorHistogram& h : histograms) {
        labels.push_back(h.label);
        for (std::size_t k = 0; k < classes; ++k) top = std::max(top, percentOf(h, k));
    }
    Chart chart(canvas, classes, histograms.size(), top);
    chart.heading("Error under the front flippers",
                  "how often |error| of a bin's height falls into each class, by method");
    chart.axes("|error| [mm]", "share of the bins [%]");
    const double bar = 0.84 * chart.classWidth() / static_cast<double>(histograms.size());
    for (std::size_t k = 0; k < classes; ++k) {
        const bool last = k + 1 == classes;
        chart.labelClass(chart.classBegin(k),
                         fmt::format("{}{:g}", last ? "≥ " : "",
                                     1000.0 * histograms[0].width * static_cast<double>(k)));
        double x = chart.classBegin(k) + 0.08 * chart.classWidth();
        for (const ErrorHistogram& h : histograms) {
            canvas.fillRectangle({x, chart.y(percentOf(h, k))}, {x + bar - 1.0, kBottom},
                                 styleOf(h.label).colour);
            x += bar;
        }
    }
    chart.key(labels, true);
}

void drawQuartiles(Canvas& canvas, std::span<const MethodSummary> summaries)
{
    double top = 1.0;
    std::vector<std::string> labels;
    for (const MethodSummary& m : summaries) {
        labels.push_back(m.label);
        for (const ErrorStatistics& s : m.bin) top = std::max(top, 1000.0 * s.q3);
    }
    Chart chart(canvas, kBins, summaries.size(), top);
    chart.heading(
        "Error of every bin",
        "|error| of a bin's height: median, bar from the first to the third quartile, by method");
    chart.axes("bin, forward from the IMU [m]", "|error| [mm]");
    const double apart = 0.8 * chart.classWidth() / static_cast<double>(summaries.size());
    for (std::size_t i = 0; i < kBins; ++i) {
        if (i > 0)
            canvas.line({chart.classBegin(i), kTop}, {chart.classBegin(i), kBottom},
                        {kFigureGrid, 1.0, {}});
        chart.labelClass(chart.classBegin(i) + 0.5 * chart.classWidth(),
                         signedNumber(binCentre(static_cast<int>(i)), 1));
        double x = chart.classBegin(i) + 0.1 * chart.classWidth() + 0.5 * apart;
        for (const MethodSummary& m : summaries) {
            const MethodStyle look = styleOf(m.label);
            const ErrorStatistics& s = m.bin[i];
            const auto y = [&](double metres) { return chart.y(1000.0 * metres); };
            if (s.n > 0) {
                canvas.line({x, y(s.q1)}, {x, y(s.q3)}, {look.colour, look.hollow ? 1.5 : 3.0, {}});
                drawMarker(canvas, look, {x, y(s.median)}, 1.0);
            }
            x += apart;
        }
    }
    chart.key(labels, false);
}

/// Panels of histograms with a common scale, three per row.
class Panels {
public:
    static constexpr std::size_t kPerRow = 3;
    static constexpr double kRowHeight = 230.0, kHead = 84.0, kFoot = 30.0, kPanelLeft = 60.0,
                            kPanelWidth = 330.0, kPanelHeight = 160.0, kApart = 380.0;

    static int height(std::size_t panels)
    {
        const std::size_t rows = (panels + kPerRow - 1) / kPerRow;
        return static_cast<int>(kHead + kFoot + kRowHeight * static_cast<double>(rows));
    }

    Panels(Canvas& canvas, double top) : canvas_(canvas), step_(niceStep(2.0 * top))
    {
        top_ = step_ * std::ceil(top / step_);
    }

    void draw(std::size_t place, const ErrorHistogram& h)
    {
        left_ = kPanelLeft + kApart * static_cast<double>(place % kPerRow);
        const std::size_t row = place / kPerRow;
        floor_ = kHead + 20.0 + kPanelHeight + kRowHeight * static_cast<double>(row);
        const MethodStyle look = styleOf(h.label);
        canvas_.text({left_, floor_ - kPanelHeight - 8.0}, look.words,
                     {.colour = kFigureText, .size = 15.0, .bold = true});
        scale();
        const auto classes = static_cast<double>(h.count.size());
        for (std::size_t k = 0; k < h.count.size(); ++k)
            canvas_.fillRectangle({x(static_cast<double>(k) / classes) + 1.0, y(percentOf(h, k))},
                                  {x(static_cast<double>(k + 1) / classes) - 1.0, floor_},
                                  look.colour);
        canvas_.line({left_, y(100.0 / classes)}, {x(1.0), y(100.0 / classes)},
                     {kFigureText, 1.5, {6.0, 4.0}});
    }

private:
    double x(double pit) const { return left_ + kPanelWidth * pit; }
    double y(double percent) const { return floor_ - kPanelHeight * percent / top_; }

    void scale()
    {
        const TextStyle right{.colour = kFigureMuted, .size = 13.0, .align = Align::Right};
        const TextStyle centre{.colour = kFigureMuted, .size = 13.0, .align = Align::Centre};
        for (int k = 0; k * step_ <= top_ * (1.0 + 1e-9); ++k) {
            canvas_.line({left_, y(k * step_)}, {x(1.0), y(k * step_)}, {kFigureGrid, 1.0, {}});
            canvas_.text({left_ - 6.0, y(k * step_) + 4.0}, fmt::format("{:g}", k * step_), right);
        }
        for (const double pit : {0.0, 0.5, 1.0})
            canvas_.text({x(pit), floor_ + 18.0}, fmt::format("{:g}", pit), centre);
    }

    Canvas& canvas_;
    double step_;
    double top_ = 1.0;
    double left_ = 0.0, floor_ = 0.0;
};

void drawPanels(Canvas& canvas, std::span<const ErrorHistogram> histograms)
{
    double top = 1.0;
    for (const ErrorHistogram& h : histograms)
        for (std::size_t k = 0; k < h.count.size(); ++k) top = std::max(top, percentOf(h, k));
    canvas.text({24.0, 36.0}, "Calibration", {.colour = kFigureText, .size = 21.0, .bold = true});
    canvas.text({24.0, 62.0},
                "share of the bins [%] by the probability that was given to a height below the "
                "true one (PIT); dashed: a calibrated forecast",
                {.colour = kFigureMuted, .size = 14.0});
    Panels panels(canvas, top);
    for (std::size_t k = 0; k < histograms.size(); ++k) panels.draw(k, histograms[k]);
}

void checkClasses(std::span<const ErrorHistogram> histograms, const char* who)
{
    if (histograms.empty()) throw std::invalid_argument(fmt::format("{}: no histograms", who));
    for (const ErrorHistogram& h : histograms)
        if (h.width != histograms[0].width || h.count.size() != histograms[0].count.size())
            throw std::invalid_argument(fmt::format("{}: histograms of different classes", who));
}

}  // namespace

Status writeHistogramFigure(const std::string& path, std::span<const ErrorHistogram> histograms,
                            const FileWriter& write)
{
    checkClasses(histograms, "writeHistogramFigure");
    return writePicture(
        path, widthFor(histograms.size()), kHeight,
        [&](Canvas& canvas) { drawHistograms(canvas, histograms); }, {}, write);
}

Status writeQuartileFigure(const std::string& path, std::span<const MethodSummary> summaries,
                           const FileWriter& write)
{
    if (summaries.empty()) throw std::invalid_argument("writeQuartileFigure: no summaries");
    return writePicture(
        path, widthFor(summaries.size()), kHeight,
        [&](Canvas& canvas) { drawQuartiles(canvas, summaries); }, {}, write);
}

Status writePitFigure(const std::string& path, std::span<const ErrorHistogram> histograms,
                      const FileWriter& write)
{
    checkClasses(histograms, "writePitFigure");
    return writePicture(
        path, kWidth, Panels::height(histograms.size()),
        [&](Canvas& canvas) { drawPanels(canvas, histograms); }, {}, write);
}

}  // namespace terratact
