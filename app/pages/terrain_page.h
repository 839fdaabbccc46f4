#pragma once

#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/display/drive_view_state.h"
#include "app/pages/terrain_layout.h"
#include "core/atem/atem_machine.h"
#include "core/atem/contact_watch.h"
#include "core/atem/speed_meter.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/robot/attitude.h"
#include "core/robot/robot_model.h"
#include "core/strip/strip.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/robot_readout.h"
#include "widgets/signals/force_bars.h"

class QLabel;
class QPushButton;

namespace terratact {

class Card;
class DrivePad;
class DriveStrip;
class ElidedLabel;
class EstimateStrip;
class EventList;
class PictureTools;
class RearView;
class TerrainProfileView;
class VerdictStrip;

/// An estimate to draw; null: none. The page redraws it only if its revision changes.
struct DrawnEstimate {
    const TwoTrackEstimate* estimate = nullptr;
    std::uint64_t revision = 0;

    explicit operator bool() const { return estimate != nullptr; }
    const TwoTrackEstimate& operator*() const { return *estimate; }
    const TwoTrackEstimate* operator->() const { return estimate; }
    /// Returns the revision; empty without an estimate.
    std::optional<std::uint64_t> shown() const
    {
        return estimate ? std::optional(revision) : std::nullopt;
    }
};

/// An estimate of the past that is drawn instead of the present one. It changes the picture alone; null: none.
struct PastDrawing {
    DrawnEstimate estimate{};
    const Measurement* scene = nullptr;
    const std::optional<Heights>* truth = nullptr;
    const std::optional<std::array<Heights, 2>>* sideTruth = nullptr;  ///< left, right
    QString note{};  ///< says that it is not the present one

    explicit operator bool() const { return estimate.operator bool(); }
};

/// State of robot and exploration at one time, as shown by the page. Pointers are used during setViewState() only;
/// null: no value.
struct TerrainViewState {
    double now = 0.0;    ///< [s] on the telemetry's clock
    bool ended = false;  ///< no more telemetry will arrive

    const Measurement* measurement = nullptr;  ///< the newest measurement
    /// [s] age of the measurement. Above kStaleAfter the picture is muted, and numbers read "--".
    double age = 0.0;
    std::optional<RobotReadout::Ages> ages{};  ///< ages of its values; empty: all have `age`
    Attitude attitude{};      ///< tip-over assessment of the measurement with the current limits
    bool numbersDue = true;   ///< numbers are updated, not only the drawing
    double numbersFor = 0.0;  ///< [s] longest time until the next update of numbers
    std::uint64_t count = 0;  ///< changes with every measurement
    const std::vector<ForceArray>* forces = nullptr;  ///< forces of the measurement
    std::optional<double> forcesAge{};                ///< [s] age of the oldest force; empty: `age`
    /// If set, the peaks come from these forces instead of earlier calls.
    const std::vector<TimedForces>* forcesBefore = nullptr;
    const std::optional<Heights>* truth = nullptr;  ///< true terrain, if the source has it

    const Measurement* scene = nullptr;  ///< the captured scene
    const std::optional<Heights>* sceneTruth = nullptr;
    /// True terrain of each side: left, right. It is drawn where both sides are estimated.
    const std::optional<std::array<Heights, 2>>* sceneSideTruth = nullptr;
    DrawnEstimate estimate{};      ///< estimate of the scene
    double estimateSeconds = 0.0;  ///< [s] computation time
    QString memoryText{};          ///< how much of the way the estimate remembers, or why nothing
    DrawnEstimate second{};        ///< estimate by a second method
    QString secondName{};
    DrawnEstimate live{};  ///< live preview, shown instead of the estimate
    PastDrawing past{};    ///< drawn instead of `estimate`
    QString whyNoEstimate{};
    SeenStrip remembered{};                 ///< ground that was felt along the way
    std::vector<EarlierSection> earlier{};  ///< ground that was felt before a break, newest first
    QString whyNothingRemembered{};         ///< reason that nothing is; empty: none to show
    std::optional<TwoTrackVerdict> verdict{};

    AtemState state{};
    QString stateText{};              ///< replaces the state's own text
    std::optional<PhaseTime> time{};  ///< time of the phase
    double secondsInPhase = 0.0;
    /// Probe proposal for the estimate, pending or answered.
    const ProbeProposal* proposal = nullptr;
    /// Without a proposal: the best probe and its worth.
    std::optional<ProbeProposal> bestProbe{};
    QString whyNoBestProbe{};  ///< without a proposal: reason that there is no bestProbe
    /// Reason that bestProbe is not proposed; empty: it was, or is elsewhere.
    QString whyNotOffered{};
    std::optional<ProbePlace> probingPlace{};  ///< where the arm probes now
    double probeSeconds = 0.0;                 ///< [s] expected duration of a probe
    std::optional<double> progress{};          ///< 0 … 1 of a running estimate

    /// Preconditions of exploring, driving, arming, approving a probe and releasing STOP.
    QList<Precondition> preconditions{}, driving{}, arming{}, probing{}, releasing{};
    QList<Precondition> feeling{};  ///< preconditions of feel forward
};

/// The page of terrain, exploration and probe, used by console and review. They fill it with a TerrainViewState and
/// listen to its widgets.
class TerrainPage final : public QWidget {
    Q_OBJECT
public:
    explicit TerrainPage(RobotModel robot, QWidget* parent = nullptr);

    void setViewState(const TerrainViewState& viewState);
    /// fontScale: current font scale [%].
    void arrange(Layout layout, int fontScale);
    void setThreshold(double newtons);   ///< contact threshold
    void addTerrainTool(QWidget* tool);  ///< adds a tool to the terrain's title
    // The following functions forward to TerrainLayout.
    QWidget* lower() const { return layout_->lower(); }
    void placeLower() { layout_->placeLower(); }
    void stackLower(bool stacked) { layout_->stackLower(stacked); }
    QWidget* decisions() const { return layout_->decisions(); }
    void placeDecisions() { layout_->placeDecisions(); }
    void setVerdictBeside(int columnWidth) { layout_->setVerdictBeside(columnWidth); }
    void allowTight(const ConsoleWindow& window) { layout_->allowTight(window); }
    bool isTight() const { return layout_->isTight(); }

    /// Independent of the content, so that no text resizes the window.
    QSize minimumSizeHint() const override;

    /// Returns true once the last update showed the present estimate.
    bool showsEstimate() const { return shownEstimate_; }

    AtemPanel* atemPanel() const { return atem_; }
    DrivePad* drivePad() const { return drive_; }
    DriveStrip* driveStrip() const { return driving_; }
    EventList* events() const { return events_; }
    ForceBars* forces() const { return forces_; }
    QPushButton* forceUnitButton() const { return forceUnit_; }
    ForceBars* rearForces() const { return rearForces_; }
    /// Shows the rear flippers' forces instead of the front ones. Visible if the robot has elements there.
    QPushButton* rearForcesButton() const { return rearButton_; }
    ProbeCard* probeCard() const { return probe_; }
    RobotReadout* readout() const { return readout_; }
    RearView* rearView() const { return rear_; }
    EstimateStrip* strip() const { return strip_; }
    TerrainProfileView* terrain() const { return terrain_; }
    PictureTools* pictureTools() const { return tools_; }
    VerdictStrip* verdict() const { return verdict_; }
    QPushButton* viewButton() const { return view_; }

signals:
    void tightened(bool tight);  ///< emitted when lower() must leave or may return: placeLower()

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    Card* terrainCard();
    Card* forceCard();
    void addRearForces(Card& card);
    void showRearForces(const TerrainViewState& viewState);
    void showAxle();  ///< shows the forces of the chosen flippers, front or rear
    Card* robotCard();
    Card* eventCard();
    void showRobot(const TerrainViewState& viewState);
    DriveViewState driveViewState(const TerrainViewState& viewState);
    void showDrive(const TerrainViewState& viewState);
    void showContacts(const TerrainViewState& viewState);
    void drawContacts();
    void showOutlines();
    void showTruth();
    void showAge(const TerrainViewState& viewState);
    void showEstimate(const TerrainViewState& viewState);
    void showPreview(const TerrainViewState& viewState);
    bool showPast(const TerrainViewState& viewState);
    void showPose(const TerrainViewState& viewState);
    void clearPose();  ///< draws neither a robot nor true heights
    void showVerdict(const TerrainViewState& viewState);
    void showProbe(const TerrainViewState& viewState);
    void showProbeToAsk(const TerrainViewState& viewState);
    void showForcesAge(const TerrainViewState& viewState);
    void showThreshold();

    RobotModel robot_;
    double threshold_ = 0.0;
    std::optional<double> forcesAge_;  ///< [s] age shown instead of stale forces

    // Qt's parents own the widgets.
    VerdictStrip* verdict_ = nullptr;
    Card* terrainCard_ = nullptr;
    QPushButton* view_ = nullptr;
    EstimateStrip* strip_ = nullptr;
    TerrainProfileView* terrain_ = nullptr;
    PictureTools* tools_ = nullptr;
    AtemPanel* atem_ = nullptr;
    ProbeCard* probe_ = nullptr;
    ForceBars* forces_ = nullptr;
    ElidedLabel* forceLegend_ = nullptr;
    QPushButton* forceUnit_ = nullptr;
    Card* forcesCard_ = nullptr;
    ForceBars* rearForces_ = nullptr;
    QPushButton* rearButton_ = nullptr;
    QLabel* thresholdText_ = nullptr;
    RobotReadout* readout_ = nullptr;
    RearView* rear_ = nullptr;
    QLabel* robotAge_ = nullptr;
    bool numbersFresh_ = false;  ///< the robot's numbers were fresh in the last update
    DrivePad* drive_ = nullptr;
    DriveStrip* driving_ = nullptr;
    EventList* events_ = nullptr;
    TerrainLayout* layout_ = nullptr;

    bool marksContacts_ = false;  ///< in the picture
    ContactWatch contacts_{0.0};  ///< setThreshold() sets its threshold
    SpeedMeter speed_;
    std::uint64_t driveCount_ = 0;  ///< TerrainViewState::count of their last line
    std::uint64_t shownCount_ = 0;
    std::optional<std::uint64_t> shown_, shownLive_, shownSecond_;  ///< revisions; empty: none
    std::optional<std::uint64_t> shownPast_;  ///< revision; empty: the present is drawn
    QString shownReason_;
    bool shownEstimate_ = false;
    std::optional<Heights> planeTruth_;
    std::optional<std::array<Heights, 2>> sideTruth_;  ///< left, right
    std::optional<Measurement> posed_;                 ///< the robot is drawn in this pose
    bool isOnePlane_ = true;                           ///< posed_ is drawn without its sides
};

}  // namespace terratact
