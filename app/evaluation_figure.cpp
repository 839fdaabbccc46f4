#include "app/evaluation_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "app/canvas.h"

namespace terratact {
namespace {

constexpr int kWidth = 1200, kHeight = 700;
constexpr double kLeft = 84.0, kRight = 1170.0, kTop = 84.0, kBottom = 590.0;
constexpr Colour kText{0x16222e}, kMuted{0x4a5866}, kGrid{0xe4e9ee}, kFrame{0xcfd8e1};

struct Look {
    Colour colour;
    Shape shape;
    double size;             ///< [px]
    std::string_view words;  ///< as the paper writes it
};

Look lookOf(Method method)
{
    switch (method) {
    case Method::Pa: return {{0x7b8794}, Shape::Circle, 12.0, "PA"};
    case Method::Pac: return {{0x1558a6}, Shape::Square, 11.0, "PAC"};
    case Method::Pafc: return {{0x12804a}, Shape::Diamond, 15.0, "PAFc"};
    case Method::Pafac: return {{0x8e3fbf}, Shape::Triangle, 14.0, "PAFAc"};
    case Method::Clearance: return {{0xb8560b}, Shape::Circle, 12.0, "clearance"};
    case Method::Joint: return {{0x0b7f8c}, Shape::Square, 11.0, "joint"};
    case Method::Local: return {{0xb01e4f}, Shape::Diamond, 15.0, "local"};
    }
    return {};
}

/// 1, 2 or 5 times a power of ten, at most eight steps up to `top`.
double niceStep(double top)
{
    const double power = std::pow(10.0, std::floor(std::log10(top / 8.0)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power * 8.0 >= top) return factor * power;
    return 10.0 * power;
}

/// Classes side by side in x, an axis from 0 upwards in y.
class Chart {
public:
    Chart(Canvas& canvas, std::size_t classes, double top)
        : canvas_(canvas), classes_(classes), step_(niceStep(top))
    {
        top_ = step_ * std::ceil(top / step_);
    }
    double y(double value) const { return kBottom - (kBottom - kTop) * value / top_; }
    double classWidth() const { return (kRight - kLeft) / static_cast<double>(classes_); }
    double classBegin(std::size_t k) const { return kLeft + classWidth() * static_cast<double>(k); }

    void heading(std::string_view title, std::string_view subtitle)
    {
        canvas_.text({24.0, 36.0}, title, {.colour = kText, .size = 21.0, .bold = true});
        canvas_.text({24.0, 62.0}, subtitle, {.colour = kMuted, .size = 14.0});
    }

    void axes(std::string_view across, std::string_view up)
    {
        const TextStyle right{.colour = kMuted, .size = 14.0, .align = Align::Right};
        const TextStyle centre{.colour = kMuted, .size = 14.0, .align = Align::Centre};
        for (int k = 0; k * step_ <= top_ * (1.0 + 1e-9); ++k) {
            canvas_.line({kLeft, y(k * step_)}, {kRight, y(k * step_)},
                         {k == 0 ? kFrame : kGrid, 1.0, {}});
            canvas_.text({kLeft - 8.0, y(k * step_) + 5.0}, fmt::format("{:g}", k * step_), right);
        }
        canvas_.text({0.5 * (kLeft + kRight), kBottom + 44.0}, across, centre);
        canvas_.text({26.0, 0.5 * (kTop + kBottom)}, up, centre, true);
    }

    void labelClass(double x, std::string_view words)
    {
        canvas_.text({x, kBottom + 20.0}, words,
                     {.colour = kMuted, .size = 14.0, .align = Align::Centre});
    }

    void key(const std::vector<Method>& methods, bool bars)
    {
        std::vector<KeyEntry> entries;
        for (const Method method : methods) {
            const Look look = lookOf(method);
            entries.push_back({std::string(look.words), [look, bars](Canvas& canvas, Point at) {
                                   if (bars)
                                       canvas.fillRectangle({at.x - 12.0, at.y - 7.0},
                                                            {at.x + 12.0, at.y + 7.0}, look.colour);
                                   else
                                       canvas.marker(look.shape, at, look.size, look.colour,
                                                     {look.colour, 1.0, {}});
                               }});
        }
        drawKey(canvas_, {kLeft, kBottom + 58.0}, kRight, entries);
    }

private:
    Canvas& canvas_;
    std::size_t classes_;
    double step_;
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
    std::vector<Method> methods;
    for (const ErrorHistogram& h : histograms) {
        methods.push_back(h.method);
        for (std::size_t k = 0; k < classes; ++k) top = std::max(top, percentOf(h, k));
    }
    Chart chart(canvas, classes, top);
    chart.heading("Error under the front flippers",
                  "how often |error| of a bin's mean falls into each class, by method");
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
                                 lookOf(h.method).colour);
            x += bar;
        }
    }
    chart.key(methods, true);
}

void drawQuartiles(Canvas& canvas, std::span<const MethodSummary> summaries)
{
    double top = 1.0;
    std::vector<Method> methods;
    for (const MethodSummary& m : summaries) {
        methods.push_back(m.method);
        for (const ErrorStatistics& s : m.bin) top = std::max(top, 1000.0 * s.q3);
    }
    Chart chart(canvas, kBins, top);
    chart.heading(
        "Error of every bin",
        "|error| of a bin's mean: median, bar from the first to the third quartile, by method");
    chart.axes("bin, forward from the IMU [m]", "|error| [mm]");
    const double apart = 0.8 * chart.classWidth() / static_cast<double>(summaries.size());
    for (std::size_t i = 0; i < kBins; ++i) {
        if (i > 0)
            canvas.line({chart.classBegin(i), kTop}, {chart.classBegin(i), kBottom},
                        {kGrid, 1.0, {}});
        chart.labelClass(chart.classBegin(i) + 0.5 * chart.classWidth(),
                         signedNumber(binCentre(static_cast<int>(i)), 1));
        double x = chart.classBegin(i) + 0.1 * chart.classWidth() + 0.5 * apart;
        for (const MethodSummary& m : summaries) {
            const Look look = lookOf(m.method);
            const ErrorStatistics& s = m.bin[i];
            const auto y = [&](double metres) { return chart.y(1000.0 * metres); };
            if (s.n > 0) {
                canvas.line({x, y(s.q1)}, {x, y(s.q3)}, {look.colour, 3.0, {}});
                canvas.marker(look.shape, {x, y(s.median)}, look.size, look.colour,
                              {{0xffffff}, 1.5, {}});
            }
            x += apart;
        }
    }
    chart.key(methods, false);
}

}  // namespace

Status writeHistogramFigure(const std::string& path, std::span<const ErrorHistogram> histograms)
{
    if (histograms.empty()) throw std::invalid_argument("writeHistogramFigure: no histograms");
    for (const ErrorHistogram& h : histograms)
        if (h.width != histograms[0].width || h.count.size() != histograms[0].count.size())
            throw std::invalid_argument("writeHistogramFigure: histograms of different classes");
    return writePicture(path, kWidth, kHeight,
                        [&](Canvas& canvas) { drawHistograms(canvas, histograms); });
}

Status writeQuartileFigure(const std::string& path, std::span<const MethodSummary> summaries)
{
    if (summaries.empty()) throw std::invalid_argument("writeQuartileFigure: no summaries");
    return writePicture(path, kWidth, kHeight,
                        [&](Canvas& canvas) { drawQuartiles(canvas, summaries); });
}

}  // namespace terratact
