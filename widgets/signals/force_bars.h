#pragma once

#include <QRectF>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"
#include "widgets/base/plain_plot.h"
#include "widgets/signals/peak_hold.h"

class QwtPlotGrid;
class QwtPlotMarker;

namespace terratact {

class ElementScale;
class ForceChart;
class UnitScale;

/// One force-sensing element as shown; an empty optional means not measured.
struct ForceElement {
    bool exists = true;               ///< the array has this element; otherwise the rest is empty
    std::optional<double> newtons{};  ///< [N] calibrated force
    std::optional<double> volts{};    ///< [V] raw voltage
    bool saturated = false;           ///< saturated: the force exceeds `newtons`
    std::optional<double> drift{};    ///< [N] drift of its bias
};

/// One array of elements; number 1 is at the pivot, 6 at the tip.
struct ForceArray {
    QString name;  ///< "L"; may be empty if it is the only array
    std::array<ForceElement, kForceElements> elements{};
};

/// Forces of all arrays at one time [s].
struct TimedForces {
    double time = 0.0;
    std::vector<ForceArray> arrays{};
};

/// Forces of all arrays as six groups of live bars with numbers, calibrated [N] or raw [V]. Bars of the arrays 1 to 4
/// are solid, outlined, crossed and striped. If an array lacks an element, the others share its room.
/// An element is in contact if its mean over the arrays exceeds the threshold, as in the estimate. Contacts are blue
/// and hatched; one word labels neighbouring contacts. A saturated element reads ">19" and has a triangle. A thin line
/// marks each bar's peak of the last 3 s. A bias drift above ForceDrift::kNotable is shown below its element. A missing
/// value reads "--".
class ForceBars final : public PlainPlot {
    Q_OBJECT
public:
    enum class Unit { Newtons, Volts };

    explicit ForceBars(QWidget* parent = nullptr);

    /// Shows at most kArrays arrays. `time` [s], on any one clock, is used for the peaks only.
    void setForces(std::vector<ForceArray> arrays, double time);
    /// Shows the arrays with peaks of `before` and of these forces; earlier calls do not count.
    void setForces(std::vector<ForceArray> arrays, double time,
                   const std::vector<TimedForces>& before);
    void clearForces();  ///< nothing is measured: elements read "--", and peaks vanish
    void setThreshold(double newtons);
    void setUnit(Unit unit);
    Unit unit() const { return unit_; }

    static constexpr std::size_t kArrays = 4;
    int arrays() const { return static_cast<int>(arrays_.size()); }  ///< at least 1
    /// Returns "■ L  □ R"; empty for one array without a name.
    QString legend() const;

    // Elements are 0 … 5, arrays from 0.
    bool touching(int element) const;
    QString numberText(int element,
                       int array = 0) const;  ///< number above the bar, if it has room
    QString driftText(int element) const;     ///< text below the element; empty: no drift
    std::optional<double> peak(int element,
                               int array = 0) const;   ///< [unit()] peak of the last 3 s
    QRectF barRect(int element, int array = 0) const;  ///< [px] on the canvas
    double pixelOf(double value) const;                ///< canvas y of a value in unit()
    double fullScale() const { return fullScale_; }    ///< [unit()] top of the scale

    void restyle() override;
    QSize sizeHint() const override { return {380, 140}; }
    QSize minimumSizeHint() const override { return {260, 106}; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Peaks {
        PeakHold newtons, volts;
    };

    void addPeaks(const std::vector<ForceArray>& arrays, double time);
    void show();
    void showBars();
    void showNumbers();
    void showContacts();
    void showDrifts();
    void fitScale();
    const ForceElement& at(int element, int array) const;
    std::vector<int> arraysWith(int element) const;
    std::optional<double> shown(int element, int array) const;  ///< [unit()] value of the bar
    /// [unit()] highest of bars, peaks and threshold line; numbers stand above it.
    double top(int element) const;
    QString labelText(int element) const;
    int labelRows() const;
    /// Neighbouring elements in contact, with one common word.
    struct ContactGroup {
        int first = 0, last = 0;
        double highest = 0.0;  ///< [unit()] highest bar
        qsizetype rows = 0;    ///< lines of the numbers
    };
    std::vector<ContactGroup> contactGroups() const;
    qsizetype rowsOf(int element) const;       ///< lines above the element's bar, without the word
    double shareOfRows(qsizetype rows) const;  ///< share of the canvas height
    QString spoken(int element) const;
    QString unitText() const;
    QFont labelFont(bool bold) const;
    double groupWidth() const;  ///< [px]

    std::vector<ForceArray> arrays_;
    std::vector<std::array<Peaks, kForceElements>> peaks_;  // peaks of every array
    Unit unit_ = Unit::Newtons;
    double threshold_ = 2.0;   // [N]
    double fullScale_ = 10.0;  // in unit_
    ElementScale* elementScale_ = nullptr;
    UnitScale* unitScale_ = nullptr;
    ForceChart* chart_ = nullptr;
    QwtPlotGrid* grid_ = nullptr;
    QwtPlotMarker* thresholdLine_ = nullptr;
    std::array<QwtPlotMarker*, kForceElements> numbers_{};
    /// Labels of neighbouring contacts.
    std::array<QwtPlotMarker*, kForceElements / 2> contacts_{};
};

}  // namespace terratact
