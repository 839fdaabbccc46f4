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

/// Position of the arm's tip, planned or measured.
struct ArmTip {
    enum class State { Proposed, Probing, Touched };
    State state = State::Proposed;
    int bin = 0;
    double height = 0.0;  ///< [m] measured height, if Touched
    bool operator==(const ArmTip&) const = default;
};

/// Draws a TerrainEstimate: mean line, bars between the 0.1 and 0.9 quantiles, and ceilings. The robot's side view has
/// the IMU at the origin. The scale is equal in x and z at every size, so a step looks as steep as it is. Bins differ
/// by shape, bar pattern and colour (provenance_marks.h). Contact = square, arm = triangle, constrained = inverted
/// triangle, sampled = circle, prior only = open diamond in an amber zone. Letters mark the bins where the legend has
/// no room. A bin with bimodal draws shows both heights.
/// The bin under the pointer, or selected with the arrow keys, is shown in detail. Values that are not finite or beyond
/// 100 m are left out. GUI thread only.
class TerrainProfileView final : public QwtPlot {
    Q_OBJECT
public:
    explicit TerrainProfileView(QWidget* parent = nullptr);

    /// note: a caution that is written above the profile; empty: none.
    void setEstimate(const TerrainEstimate& estimate, const QString& note = {});
    void clearEstimate(const QString& why);  ///< shows the reason instead of a flat line
    void setOutline(const Outline& outline);
    void setTruth(const std::optional<Heights>& truth);
    void setArmTip(const std::optional<ArmTip>& tip);
    void setDrawsShown(bool shown);  ///< shows some draws as thin lines
    /// Shows a second method's estimate of the same scene; empty: none. name: its legend entry.
    void setSecond(const std::optional<TerrainEstimate>& estimate, const QString& name);
    /// Shows the last estimate moved by odometry. why: the reason shown if there is no ghost; empty: nothing.
    void setGhost(const std::optional<Ghost>& ghost, const QString& why = {});
    void inspect(std::optional<int> bin);  ///< shows a bin in detail
    /// Mutes the drawing, which is `age` [s] old; empty: it is current.
    void setStale(std::optional<double> age);

    /// Shows a small widget in the upper left corner of the canvas, above the robot's rear. It leaves where it would
    /// cover a bin or a note. The view takes ownership.
    void setCorner(QWidget* corner);

    /// Returns the canvas position of a point in the DEM frame [m].
    QPointF pixelOf(double x, double z) const;
    /// Returns the point in the DEM frame [m] at a canvas position.
    QPointF pointAt(QPointF pixel) const;
    /// Returns a bin as text: "bin 0.4 m: +0.07 m, 80 % in +0.05 … +0.09, contact".
    QString binText(int bin) const;
    /// Returns the drawn estimate.
    const std::optional<TerrainEstimate>& estimate() const { return estimate_; }
    BinInspector* inspector() const { return inspector_; }
    bool drawsShown() const { return drawsShown_; }

signals:
    /// Emitted when the operator chooses a bin: by a double click, or by Enter on the bin shown in detail.
    void binChosen(int bin);

public:
    /// Applies the current theme and font; runs by itself soon after they change.
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

    void addLines();
    void addBars();
    void addMarks();
    void addLayers();
    void addNotes();
    void sizeLegend();
    void showEstimate();
    void showDraws();
    QStringList closeUp(int bin) const;
    void showNote(const QString& note, bool warns);
    void showGhostNote(const QString& note);
    void arrangeNotes();
    void placeCorner();
    void showTruth();
    void showArm();
    double underArm() const;
    void fitAxes();
    bool setScales();  ///< returns true if the scales changed
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
    QWidget* corner_ = nullptr;
};

}  // namespace terratact
