#pragma once

#include <qwt_plot.h>

#include <array>
#include <optional>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/provenance.h"
#include "core/infer/verdict/ghost.h"
#include "core/terrain/outline.h"
#include "widgets/terrain/profile_axes.h"
#include "widgets/terrain/robot_sketch.h"

class QwtPlotCurve;
class QwtPlotGrid;
class QwtPlotIntervalCurve;
class QwtPlotMarker;
class QwtPlotShapeItem;
class QwtPlotTextLabel;

namespace terratact {

class ArmMark;
class BinInspector;
class BinZones;
class GhostLayer;
class MarkLetters;
class SampleLines;
class SecondEstimate;
class TwoHeights;
class StaleOverlay;

/// Where the tip of the arm is, or would be.
struct ArmTip {
    enum class State { Proposed, Probing, Touched };
    State state = State::Proposed;
    int bin = 0;
    double height = 0.0;  ///< [m] that it found; of Touched
    bool operator==(const ArmTip&) const = default;
};

/// Draws one TerrainEstimate under the robot: mean line, bars from the 0.1 to the 0.9 quantile, ceilings,
/// the robot's side view with the IMU at the origin.  Bins are told apart by shape, by the pattern of their bars, by
/// colour and, where there is no room for the legend, by a letter each (provenance_marks.h):
/// contact = square, arm = triangle, constrained = triangle upside down, sampled = circle, prior only = open
/// diamond in an amber zone.  A bin whose draws fall into two heaps shows both heights.
/// The bin under the mouse, or chosen with the arrow keys, is shown up close.
/// One metre is as long upwards as forwards, whatever the size, so a step looks as steep as it is.
/// What is not finite, or beyond 100 m, is left out.  GUI thread only.
class TerrainProfileView final : public QwtPlot {
    Q_OBJECT
public:
    explicit TerrainProfileView(QWidget* parent = nullptr);

    /// note: written above the profile, what the reader must know before it; empty: nothing.
    void setEstimate(const TerrainEstimate& estimate, const QString& note = {});
    void clearEstimate(const QString& why);  ///< says why there is none; not a flat line
    void setOutline(const Outline& outline);
    void setTruth(const std::optional<Heights>& truth);
    void setArmTip(const std::optional<ArmTip>& tip);
    void setDrawsShown(bool shown);  ///< some draws as thin lines
    /// A second method's estimate of the same scene beside the first; empty: none.  name: in the legend.
    void setSecond(const std::optional<TerrainEstimate>& estimate, const QString& name);
    /// The last estimate where odometry says it lies now.  why: said instead, where there is none; empty: nothing.
    void setGhost(const std::optional<Ghost>& ghost, const QString& why = {});
    void inspect(std::optional<int> bin);  ///< shows a bin up close
    /// Mutes what is drawn, which is of `age` [s] ago; empty: it is as now.
    void setStale(std::optional<double> age);

    /// Canvas position of a point of the DEM frame [m].
    QPointF pixelOf(double x, double z) const;
    /// DEM frame point [m] under a canvas position.
    QPointF pointAt(QPointF pixel) const;
    /// One bin in words: "bin 0.4 m: +0.07 m, 80 % in +0.05 … +0.09, contact".
    QString binText(int bin) const;
    const std::optional<TerrainEstimate>& estimate() const { return estimate_; }  ///< that is drawn
    BinInspector* inspector() const { return inspector_; }
    bool drawsShown() const { return drawsShown_; }

signals:
    /// A bin was asked for: by a double click, or Enter on the one that is shown up close.
    void binChosen(int bin);

public:
    /// In theme and font as they are now; by itself soon after they have changed.
    void restyle();

    void updateLayout() override;
    QSize sizeHint() const override { return {760, 420}; }
    QSize minimumSizeHint() const override { return {300, 110}; }

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    static constexpr std::size_t kKinds = kProvenances.size();

    void sizeLegend();
    void showEstimate();
    void showDraws();
    QStringList closeUp(int bin) const;
    void showNote(const QString& note, bool warns);
    void showGhostNote(const QString& note);
    void arrangeNotes();
    void showTruth();
    void showArm();
    double underArm() const;
    void fitAxes();
    bool setScales();  ///< true when they had to change
    void describe();

    std::optional<TerrainEstimate> estimate_;
    std::optional<Heights> truth_;
    std::optional<ArmTip> armTip_;
    ProfileAxes axes_;
    RobotSketch robot_;

    // The plot owns its items once they are attached.
    std::array<QwtPlotCurve*, kKinds> points_{};
    std::array<QwtPlotIntervalCurve*, kKinds> bars_{};
    QwtPlotGrid* grid_ = nullptr;
    QwtPlotMarker* imu_ = nullptr;
    QwtPlotShapeItem* mean_ = nullptr;
    QwtPlotShapeItem* meanPrior_ = nullptr;
    QwtPlotShapeItem* ceilings_ = nullptr;
    QwtPlotShapeItem* truthLine_ = nullptr;
    BinZones* zones_ = nullptr;
    MarkLetters* letters_ = nullptr;
    ArmMark* armMark_ = nullptr;
    SampleLines* draws_ = nullptr;
    SecondEstimate* second_ = nullptr;
    GhostLayer* ghost_ = nullptr;
    QwtPlotTextLabel* ghostNote_ = nullptr;
    TwoHeights* twoHeights_ = nullptr;
    StaleOverlay* staleOverlay_ = nullptr;
    BinInspector* inspector_ = nullptr;
    bool drawsShown_ = false;
    QwtPlotTextLabel* note_ = nullptr;
};

}  // namespace terratact
