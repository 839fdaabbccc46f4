#include "widgets/signals/force_bars.h"

#include <qwt_plot_grid.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "widgets/base/palette.h"
#include "widgets/base/tips.h"
#include "widgets/signals/force_chart.h"

namespace terratact {
namespace {

constexpr double kLowestBar =
    0.12;  // share of the canvas height that the highest bar keeps in a low chart

void keepWithin(std::optional<double>& value, double limit)
{
    if (value && !(std::isfinite(*value) && std::abs(*value) <= limit)) value.reset();
}

}  // namespace

ForceBars::ForceBars(QWidget* parent) : PlainPlot(parent), arrays_(1), peaks_(1)
{
    setAccessibleName(tr("Forces on the front flippers"));
    elementScale_ = new ElementScale;
    setAxisScaleDraw(QwtPlot::xBottom, elementScale_);
    unitScale_ = new UnitScale;
    setAxisScaleDraw(QwtPlot::yLeft, unitScale_);
    QList<double> elements;
    for (int i = 0; i < kForceElements; ++i) elements << i;
    setAxisScaleDiv(QwtPlot::xBottom, QwtScaleDiv(-0.5, kForceElements - 0.5, {}, {}, elements));

    grid_ = new QwtPlotGrid;
    grid_->enableX(false);
    grid_->attach(this);

    chart_ = new ForceChart;
    chart_->setZ(10.0);
    chart_->attach(this);

    thresholdLine_ = new QwtPlotMarker;
    thresholdLine_->setLineStyle(QwtPlotMarker::HLine);
    thresholdLine_->setZ(20.0);
    thresholdLine_->attach(this);

    const auto label = [this](double z) {
        auto* made = new QwtPlotMarker;
        made->setLabelAlignment(Qt::AlignTop | Qt::AlignHCenter);
        made->setSpacing(2);
        made->setZ(z);
        made->attach(this);
        return made;
    };
    for (QwtPlotMarker*& number : numbers_) number = label(30.0);
    for (QwtPlotMarker*& contact : contacts_) contact = label(31.0);
    restyle();
}

void ForceBars::restyle()
{
    setCanvasBackground(theme().card);
    styleScales(13);
    axisScaleDraw(QwtPlot::yLeft)->setMinimumExtent(scaled(34));
    elementScale_->invalidateCache();  // the cache holds the old theme's colours
    grid_->setMajorPen(theme().grid, 1.0);
    thresholdLine_->setLinePen(theme().bad, 1.5, Qt::DashLine);
    show();
}

void ForceBars::resizeEvent(QResizeEvent* event)
{
    PlainPlot::resizeEvent(event);
    show();
}

void ForceBars::setForces(std::vector<ForceArray> arrays, double time)
{
    arrays.resize(std::clamp<std::size_t>(arrays.size(), 1, kArrays));
    arrays_ = std::move(arrays);
    peaks_.resize(arrays_.size());
    for (ForceArray& array : arrays_)
        for (ForceElement& element : array.elements)
            for (auto* value : {&element.newtons, &element.volts, &element.drift})
                keepWithin(*value, 1000.0);
    addPeaks(arrays_, time);
    show();
}

void ForceBars::setForces(std::vector<ForceArray> arrays, double time,
                          const std::vector<TimedForces>& before)
{
    peaks_.assign(std::clamp<std::size_t>(arrays.size(), 1, kArrays), {});
    for (const TimedForces& felt : before) addPeaks(felt.arrays, felt.time);
    setForces(std::move(arrays), time);
}

void ForceBars::addPeaks(const std::vector<ForceArray>& arrays, double time)
{
    if (!std::isfinite(time)) return;
    for (std::size_t a = 0; a < std::min(arrays.size(), peaks_.size()); ++a)
        for (std::size_t e = 0; e < kForceElements; ++e) {
            const ForceElement& element = arrays[a].elements[e];
            Peaks& peaks = peaks_[a][e];
            peaks.newtons.forget(time);
            peaks.volts.forget(time);
            const auto add = [time](PeakHold& peak, std::optional<double> value) {
                keepWithin(value, 1000.0);
                if (value) peak.add(time, *value);
            };
            add(peaks.newtons, element.newtons);
            add(peaks.volts, element.volts);
        }
}

void ForceBars::clearForces()
{
    for (ForceArray& array : arrays_)
        for (ForceElement& element : array.elements) element = {.exists = element.exists};
    for (auto& peaks : peaks_) peaks = {};
    show();
}

void ForceBars::setThreshold(double newtons)
{
    if (!(newtons >= 0.0 && newtons <= 1000.0)) return;
    threshold_ = newtons;
    show();
}

void ForceBars::setUnit(Unit unit)
{
    if (unit == unit_) return;
    unit_ = unit;
    unitScale_->setUnit(unitText());
    fullScale_ = 0.0;  // forces a new scale
    show();
}

const ForceElement& ForceBars::at(int element, int array) const
{
    return arrays_.at(static_cast<std::size_t>(array))
        .elements.at(static_cast<std::size_t>(element));
}

std::vector<int> ForceBars::arraysWith(int element) const
{
    std::vector<int> with;
    for (int a = 0; a < arrays(); ++a)
        if (at(element, a).exists) with.push_back(a);
    return with;
}

std::optional<double> ForceBars::shown(int element, int array) const
{
    const ForceElement& e = at(element, array);
    return unit_ == Unit::Newtons ? e.newtons : e.volts;
}

bool ForceBars::touching(int element) const
{
    double sum = 0.0;
    int count = 0;
    for (int a = 0; a < arrays(); ++a)
        if (const auto& force = at(element, a).newtons) {
            sum += *force;
            ++count;
        }
    return count > 0 && sum / count > threshold_;
}

std::optional<double> ForceBars::peak(int element, int array) const
{
    const Peaks& peaks =
        peaks_.at(static_cast<std::size_t>(array)).at(static_cast<std::size_t>(element));
    return unit_ == Unit::Newtons ? peaks.newtons.peak() : peaks.volts.peak();
}

QRectF ForceBars::barRect(int element, int array) const
{
    const std::vector<int> with = arraysWith(element);
    const auto place = std::find(with.begin(), with.end(), array);
    if (place == with.end()) return {};
    const Span span =
        spanOf(element, static_cast<int>(place - with.begin()), static_cast<int>(with.size()));
    return rectOf(span, shown(element, array).value_or(0.0), canvasMap(QwtPlot::xBottom),
                  canvasMap(QwtPlot::yLeft));
}

double ForceBars::pixelOf(double value) const
{
    return canvasMap(QwtPlot::yLeft).transform(value);
}

double ForceBars::groupWidth() const
{
    return canvas()->width() / static_cast<double>(kForceElements);
}

QFont ForceBars::labelFont(bool bold) const
{
    QFont face = font();
    face.setPixelSize(scaled(13));
    face.setBold(bold);
    return face;
}

double ForceBars::top(int element) const
{
    double top = unit_ == Unit::Newtons ? threshold_ : 0.0;
    for (int a = 0; a < arrays(); ++a)
        top = std::max({top, shown(element, a).value_or(0.0), peak(element, a).value_or(0.0)});
    return top;
}

// The scale grows at once and shrinks late, so that bars do not jump. Room for the numbers stays above each bar.
void ForceBars::fitScale()
{
    constexpr double kHighest = 0.8;  // share of the canvas height
    const auto scaleOf = [&](double value, qsizetype rows) {
        return value / std::clamp(1.0 - shareOfRows(rows), kLowestBar, kHighest);
    };
    double needed = 0.0;
    for (int element = 0; element < kForceElements; ++element)
        needed = std::max(needed, scaleOf(top(element), rowsOf(element)));
    for (const ContactGroup& group : contactGroups())
        needed = std::max(needed, scaleOf(group.highest, group.rows + 1));
    constexpr std::array kScales{5.0,  6.0,   8.0,   10.0,  20.0,  30.0,  40.0,   50.0,
                                 80.0, 100.0, 150.0, 200.0, 400.0, 800.0, 1000.0, 1400.0};
    const auto scaleFor = [&](double value) {
        return *std::find_if(kScales.begin(), kScales.end() - 1,
                             [=](double scale) { return value <= scale; });
    };
    const double least = unit_ == Unit::Newtons ? 10.0 : 5.0;
    if (needed > fullScale_) fullScale_ = std::max(least, scaleFor(needed));
    if (needed < 0.4 * fullScale_) fullScale_ = std::max(least, scaleFor(1.25 * needed));

    constexpr std::array kSteps{1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0};
    const double step = *std::find_if(kSteps.begin(), kSteps.end() - 1,
                                      [this](double s) { return fullScale_ / s <= 5.0; });
    QList<double> ticks;
    const int count = static_cast<int>(std::floor(fullScale_ / step + 1e-9));
    for (int i = 0; i <= count; ++i) ticks << i * step;
    setAxisScaleDiv(QwtPlot::yLeft, QwtScaleDiv(0.0, fullScale_, {}, {}, ticks));
}

void ForceBars::showBars()
{
    chart_->bars.clear();
    for (int element = 0; element < kForceElements; ++element) {
        const std::vector<int> with = arraysWith(element);
        for (std::size_t place = 0; place < with.size(); ++place) {
            const int a = with[place];
            chart_->bars.push_back(
                {.span = spanOf(element, static_cast<int>(place), static_cast<int>(with.size())),
                 .value = shown(element, a).value_or(0.0),
                 .peak = peak(element, a),
                 .touching = touching(element),
                 .saturated = at(element, a).saturated,
                 .look = arrayLook(static_cast<std::size_t>(a))});
        }
    }
}

void ForceBars::showNumbers()
{
    for (int element = 0; element < kForceElements; ++element) {
        QwtText label(labelText(element));
        label.setFont(labelFont(touching(element)));
        label.setColor(touching(element) ? theme().contact : theme().muted);
        // The background hides the threshold line, which would strike the number out.
        label.setBackgroundBrush(theme().card);
        auto* number = numbers_[static_cast<std::size_t>(element)];
        number->setValue(element, top(element));
        number->setLabel(label);
    }
}

qsizetype ForceBars::rowsOf(int element) const
{
    return labelText(element).count(QLatin1Char('\n')) + 1;
}

double ForceBars::shareOfRows(qsizetype rows) const
{
    constexpr double kSpace = 4.0;  // [px] around the labels
    const double line = QFontMetricsF(labelFont(true)).lineSpacing();
    return (kSpace + line * static_cast<double>(rows)) / std::max(1, canvas()->height());
}

std::vector<ForceBars::ContactGroup> ForceBars::contactGroups() const
{
    std::vector<ContactGroup> groups;
    for (int element = 0; element < kForceElements; ++element) {
        if (!touching(element)) continue;
        const bool goesOn = !groups.empty() && groups.back().last == element - 1;
        if (!goesOn) groups.push_back({.first = element});
        ContactGroup& group = groups.back();
        group.last = element;
        group.highest = std::max(group.highest, top(element));
        group.rows = std::max(group.rows, rowsOf(element));
    }
    return groups;
}

// One word spans neighbouring contacts, because one word per element would overlap. A chart without room has no word;
// colour, hatching and the tip still show the contact.
void ForceBars::showContacts()
{
    std::size_t used = 0;
    for (const ContactGroup& group : contactGroups()) {
        if (shareOfRows(group.rows + 1) > 1.0 - kLowestBar) continue;
        QwtText label(tr("contact") + QString(group.rows, QLatin1Char('\n')));  // above the numbers
        label.setFont(labelFont(true));
        label.setColor(theme().contact);
        QwtPlotMarker& marker = *contacts_.at(used++);
        marker.setValue((group.first + group.last) / 2.0, group.highest);
        marker.setLabel(label);
        marker.show();
    }
    for (; used < contacts_.size(); ++used) contacts_[used]->hide();
}

void ForceBars::showDrifts()
{
    const QFontMetricsF metrics(axisFont(QwtPlot::xBottom));
    std::array<QString, kForceElements> notes;
    for (int element = 0; element < kForceElements; ++element) {
        const QString drift = driftText(element);
        if (drift.isEmpty()) continue;
        const bool fits = metrics.horizontalAdvance(drift) < groupWidth();
        notes[static_cast<std::size_t>(element)] =
            fits ? ElementScale::nameOf(element + 1) + QLatin1Char('\n') + drift
                 : QStringLiteral("%1 %2\n%3")
                       .arg(element + 1)
                       .arg(drift.section(u' ', 0, 0), drift.section(u' ', 1));
    }
    const bool second = std::any_of(notes.begin(), notes.end(),
                                    [](const QString& note) { return !note.isEmpty(); });
    elementScale_->setMinimumExtent(scaled(24) + (second ? std::ceil(metrics.lineSpacing()) : 0.0));
    if (notes == elementScale_->notes()) return;
    elementScale_->setNotes(notes);
    updateLayout();
    axisWidget(QwtPlot::xBottom)->update();
}

void ForceBars::show()
{
    showDrifts();
    fitScale();
    showBars();
    showNumbers();
    showContacts();
    thresholdLine_->setYValue(threshold_);
    thresholdLine_->setVisible(unit_ == Unit::Newtons);
    QStringList lines;
    for (int element = 0; element < kForceElements; ++element) lines << spoken(element);
    setAccessibleDescription(lines.join(QLatin1Char('\n')));
    setTip(*this,
           accessibleDescription() + QLatin1Char('\n') + tr("Thin lines: highest of the last 3 s"));
    replot();
}

}  // namespace terratact
