#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/infer/estimate/provenance.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/robot/force_sensor.h"
#include "core/robot/probe_side.h"
#include "core/strip/strip.h"
#include "core/terrain/outline.h"
#include "widgets/base/plain_plot.h"
#include "widgets/terrain/contact_marks.h"
#include "widgets/terrain/profile_axes.h"
#include "widgets/terrain/robot_sketch.h"
#include "widgets/terrain/shown_sides.h"

class QwtPlotGrid;
class QwtPlotIntervalCurve;
class QwtPlotMarker;
class QwtPlotShapeItem;
class QwtPlotTextLabel;

namespace terratact {

class ArmMark;
class BinInspector;
class BinZones;
class EarlierLayer;
class LightSide;
class LineItem;
class MarkCurve;
class MarkLetters;
class MeasuredLine;
struct MeasuredEnd;
class RememberedLayer;
class SampleLines;
class SecondEstimate;
class SideKey;
class SideTags;
class TwoHeights;
class StaleOverlay;

/// Position of the arm's tip, planned or measured.
struct ArmTip {
    enum class State { Proposed, Probing, Touched };
    State state = State::Proposed;
    int bin = 0;
    double height = 0.0;  ///< [m] measured height, if Touched
    ProbeSide side = ProbeSide::Middle;
    bool operator==(const ArmTip&) const = default;
};

/// Draws a TerrainEstimate: mean line, bars between the 0.1 and 0.9 quantiles, and ceilings. A bin ahead that is not
/// felt has no bar, because it would look measured. The robot's side view has
/// the IMU at the origin. The scale is equal in x and z at every size, so a step looks as steep as it is. Bins differ
/// by shape, bar pattern and colour (provenance_marks.h). Contact = square, arm = triangle, constrained = inverted
/// triangle, sampled = circle, prior only = open diamond in an amber zone. A mark is filled where the bin was felt. Its
/// lower half is filled where the bin was felt in part. Otherwise it is open. Letters mark the bins if the legend does
/// not fit. A bin with bimodal draws shows both heights. Of two sides, one is drawn in full and the other one lighter,
/// beside it. The right side's line is solid and ends with R. The left side's line is hollow and ends with L.
/// The wheel, + and − zoom. Dragging and Shift with an arrow key pan. A double click or 0 shows the robot again. Two
/// fingers zoom and pan, a resting one shows a bin in detail. Remembered ground (remembered_layer.h) reaches beyond the
/// picture.
/// While measuring, a drag sets two points. Their distance, rise and slope are shown with the bands of both heights. A
/// point that is not felt is named (measured_line.h). The arrow keys move the second point from bin to bin.
/// The bin under the pointer, or selected with the arrow keys, is shown in detail. Values that are not finite or beyond
/// 100 m are left out. GUI thread only.
class TerrainProfileView final : public PlainPlot {
    Q_OBJECT
public:
    explicit TerrainProfileView(QWidget* parent = nullptr);

    /// note: a caution that is written above the profile; empty: none.
    void setEstimate(const TwoTrackEstimate& estimate, const QString& note = {});
    /// Shows an estimate of one plane.
    void setEstimate(const TerrainEstimate& plane, const QString& note = {})
    {
        setEstimate(equalSides(plane), note);
    }
    QString note() const;  ///< the caution or the reason above the profile
    void setShownSides(ShownSides sides);
    ShownSides shownSides() const { return shownSides_; }
    /// Sets the side that is drawn in full while both are shown.
    void setFullSide(Side side);
    /// Returns the side that is drawn in full; empty: one plane, or no estimate.
    std::optional<Side> sideInFull() const;
    /// Returns the side of a probe that the operator requests at a bin chosen in the picture.
    ProbeSide sideToProbe() const;
    /// Returns the bin shown in detail, on that side; empty: none.
    std::optional<ProbePlace> selectedPlace() const;
    void clearEstimate(const QString& why);  ///< shows the reason instead of a flat line
    /// far: the robot's other side, drawn lighter behind it; empty: both sides look the same.
    void setOutline(const Outline& outline, const Outline& far = {});
    void setTruth(const std::optional<Heights>& truth);
    void setArmTip(const std::optional<ArmTip>& tip);
    /// Marks the contacts of the robot's flippers; none: nothing touches the ground.
    void setContacts(std::vector<ContactPoint> points);
    /// Returns the words at the contacts: "CONTACT L5 R5"; empty without one.
    QString contactText() const { return contacts_->words(); }
    void setDrawsShown(bool shown);  ///< shows some draws as thin lines
    /// Shows a second method's estimate of the same scene; empty: none. name: its legend entry.
    /// Of two sides it is that of the side in full.
    void setSecond(const std::optional<TwoTrackEstimate>& estimate, const QString& name);
    /// Shows the ground that was felt along the way. With an estimate, only the part behind the estimate is shown. why:
    /// the reason shown if nothing is remembered; empty: no reason is shown.
    void setRemembered(const SeenStrip& strip, const QString& why = {});
    /// Shows the sections before a break, newest first, behind all other ground (earlier_layer.h).
    void setEarlier(const std::vector<EarlierSection>& sections);
    /// Shows `factor` times the width, with x [m] at its place. From two bins to all ground can be seen.
    void zoom(double factor, double x);
    void zoomAt(double factor, QPointF at);  ///< the same with a point [m] at its place
    void pan(double metres);                 ///< moves the window forward, within all ground
    void panBy(QPointF metres);  ///< the same upwards, too, where the picture is close up
    void resetZoom();
    void setMeasuring(bool on);
    bool measures() const { return measures_; }
    /// Returns the measurement as lines (measuredText()); empty: the view does not measure.
    QStringList measuredLines() const;
    bool isZoomed() const { return axes_.zoom() != 1.0 || axes_.shift() != 0.0; }
    void inspect(std::optional<int> bin);  ///< shows a bin in detail
    /// Mutes the drawing, which is `age` [s] old, and writes that age over it; empty: it is current.
    void setStale(std::optional<double> age);

    /// Shows a small widget in the upper left corner of the canvas, beside the bins. If it does not fit there, it gets
    /// its minimum size above the robot. It is hidden if it would cover a note or anything drawn. The view takes
    /// ownership.
    void setCorner(QWidget* corner);

    /// Returns the canvas position of a point in the DEM frame [m].
    QPointF pixelOf(double x, double z) const;
    /// Returns the point in the DEM frame [m] at a canvas position.
    QPointF pointAt(QPointF pixel) const;
    /// Returns a bin as text: "bin 0.4 m: +0.07 m, 80 % in +0.05 … +0.09, contact". Of two sides it is that of the side
    /// in full.
    QString binText(int bin) const;
    /// Returns the drawn estimate.
    const std::optional<TwoTrackEstimate>& estimate() const { return estimate_; }
    BinInspector* inspector() const { return inspector_; }
    bool drawsShown() const { return drawsShown_; }

signals:
    /// Emitted when the operator chooses a bin: by a double click, or by Enter on the bin shown in detail. Of
    /// two sides it is on the one in full.
    void binChosen(terratact::ProbePlace place);
    void shownSidesChanged();
    void measuringChanged(bool on);

public:
    void restyle() override;
    void updateLayout() override;
    QSize sizeHint() const override { return {760, 420}; }
    QSize minimumSizeHint() const override { return {300, 110}; }

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    static constexpr std::size_t kKinds = kProvenances.size();
    /// An end of the measurement as it was chosen [m].
    struct PictureEnd {
        QPointF at;
        bool isOnGround = true;  ///< at the height of the ground, wherever that will be
    };

    void addLines();
    void addBars();
    void addMarks();
    void addLayers();
    void addNotes();
    void sizeLegend();
    void addSides();
    void styleSides();
    void showEstimate();
    void showBins(const TerrainEstimate& estimate);
    void showSides();
    void showDraws();
    void showSecond();
    QStringList closeUp(int bin) const;
    QStringList briefly(int bin, Side side) const;
    QString binTextOf(const TerrainEstimate& estimate, int bin) const;
    /// Return the estimates that are drawn in full and lighter; null: none.
    const TerrainEstimate* full() const;
    const TerrainEstimate* light() const;
    const TerrainEstimate& of(Side side) const { return estimate_->side[indexOf(side)]; }
    void showNote(const QString& note, bool warns);
    void showRemembered();
    void setWindow(double zoom, double shift, double rise);
    void showWindow();
    double middleHeight() const;
    bool navigate(QEvent& event);
    bool navigateByKey(const QKeyEvent& event);
    // What a pointer does: the mouse, or a finger [px].
    void press(QPointF pixel);
    void drag(QPointF pixel);
    void choose(QPointF pixel);
    void addTouch();
    MeasuredEnd groundAt(double x) const;
    PictureEnd endNear(QPointF at) const;
    MeasuredEnd measuredEnd(const PictureEnd& end) const;
    void showMeasurement();
    bool measureByKey(const QKeyEvent& event);
    void arrangeNotes();
    int bottomOf(const QwtPlotTextLabel& note) const;
    void placeCorner();
    bool isFreeAbove(const QRect& place) const;
    void showTruth();
    void showArm();
    double underArm() const;
    void fitAxes();
    bool setScales();  ///< returns true if the scales changed
    void describe();

    std::optional<TwoTrackEstimate> estimate_, secondEstimate_;
    ShownSides shownSides_ = ShownSides::Both;
    Side fullSide_ = Side::Right;  ///< while both are shown
    std::optional<Heights> truth_;
    std::optional<ArmTip> armTip_;
    ProfileAxes axes_;
    RobotSketch farRobot_, robot_;

    // The plot owns its items once they are attached.
    std::array<MarkCurve*, kKinds> points_{};
    std::array<QwtPlotIntervalCurve*, kKinds> bars_{};
    QwtPlotGrid* grid_ = nullptr;
    QwtPlotMarker* imu_ = nullptr;
    QwtPlotShapeItem* mean_ = nullptr;
    QwtPlotShapeItem* meanPrior_ = nullptr;
    QwtPlotShapeItem* meanCore_ = nullptr;       ///< makes the line of the left side hollow
    QwtPlotShapeItem* meanPriorCore_ = nullptr;  ///< the same
    LightSide* lightSide_ = nullptr;
    SideTags* sideTags_ = nullptr;
    std::array<SideKey*, 2> sideKeys_{};
    QwtPlotShapeItem* ceilings_ = nullptr;
    QwtPlotShapeItem* truthLine_ = nullptr;
    BinZones* zones_ = nullptr;
    MarkLetters* letters_ = nullptr;
    ArmMark* armMark_ = nullptr;
    ContactMarks* contacts_ = nullptr;
    SampleLines* draws_ = nullptr;
    SecondEstimate* second_ = nullptr;
    RememberedLayer* remembered_ = nullptr;
    EarlierLayer* earlier_ = nullptr;
    QwtPlotTextLabel* rememberedNote_ = nullptr;
    QString whyNothingRemembered_;
    std::optional<QPointF> grabbed_;  ///< [m] under the pointer since it was pressed
    bool measures_ = false;
    bool isDrawn_ = false;  ///< the drag has begun a measurement
    std::array<PictureEnd, 2> ends_{};
    MeasuredLine* measured_ = nullptr;
    TwoHeights* twoHeights_ = nullptr;
    StaleOverlay* staleOverlay_ = nullptr;
    BinInspector* inspector_ = nullptr;
    bool drawsShown_ = false;
    QwtPlotTextLabel* note_ = nullptr;
    QWidget* corner_ = nullptr;
};

}  // namespace terratact
