#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "app/pages/terrain_layout.h"
#include "core/atem/atem_machine.h"
#include "core/infer/estimate/estimate.h"
#include "core/infer/verdict/ghost.h"
#include "core/infer/verdict/verdict.h"
#include "core/robot/attitude.h"
#include "core/robot/robot_model.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/robot_readout.h"
#include "widgets/signals/force_bars.h"

class QLabel;
class QPushButton;

namespace terratact {

class Card;
class DrivePad;
class ElidedLabel;
class EstimateStrip;
class EventList;
class TerrainProfileView;
class VerdictStrip;

/// What there is to see of the robot and its exploration at one time.  What is pointed to is used in setViewState() only;
/// null: there is none.
struct TerrainViewState {
    double now = 0.0;    ///< [s] on the clock of the telemetry
    bool ended = false;  ///< nothing more will come

    const Measurement* measurement = nullptr;  ///< the newest
    double age = 0.0;                          ///< [s] of it
    std::optional<RobotReadout::Ages> ages{};  ///< of its values; empty: all are of that age
    Attitude attitude{};                       ///< of it, for the limits of now
    bool numbersDue = true;                    ///< its numbers are to be shown, not only drawn
    double numbersFor = 0.0;                   ///< [s] at most, until they are shown anew
    std::uint64_t count = 0;                   ///< another for another measurement
    const std::vector<ForceArray>* forces = nullptr;  ///< of it
    std::optional<double> forcesAge{};  ///< [s] of the oldest; empty: they are of that age
    /// Set: the peaks are of these, whatever was shown before.
    const std::vector<TimedForces>* forcesBefore = nullptr;
    const std::optional<Heights>* truth = nullptr;  ///< that its source knows

    const Measurement* scene = nullptr;  ///< that was captured
    const std::optional<Heights>* sceneTruth = nullptr;
    const TerrainEstimate* estimate = nullptr;  ///< of it
    double estimateSeconds = 0.0;               ///< it took
    const TerrainEstimate* second = nullptr;    ///< of it, too
    QString secondName{};
    const TerrainEstimate* live = nullptr;  ///< a preview, shown instead
    QString whyNoEstimate{};
    std::optional<Ghost> ghost{};  ///< where the last estimate lies now
    QString whyNoGhost{};          ///< said where there is none; empty: nothing
    std::optional<Verdict> verdict{};

    AtemState state{};
    QString stateWords{};             ///< where more is known than the state itself says
    std::optional<PhaseTime> time{};  ///< of the phase
    double secondsInPhase = 0.0;
    const ProbeProposal* proposal = nullptr;  ///< of the estimate, whether or not it is asked
    std::optional<ProbeProposal>
        bestProbe{};          ///< without one: what the best would buy all the same
    QString whyNotOffered{};  ///< empty: it was, or would be elsewhere
    std::optional<int> probingBin{};
    double probeSeconds = 0.0;         ///< a probe takes
    std::optional<double> progress{};  ///< 0 … 1 of an estimate under way

    /// Of exploring, driving, arming, approving a probe and releasing STOP.
    QList<Precondition> preconditions{}, driving{}, arming{}, probing{}, releasing{};
};

/// The terrain under the robot, exploring it, and the arm: the cards of both the console and a review, which
/// fill it with a TerrainViewState and listen to its widgets.
class TerrainPage final : public QWidget {
    Q_OBJECT
public:
    explicit TerrainPage(RobotModel robot, QWidget* parent = nullptr);

    void setViewState(const TerrainViewState& viewState);
    /// fontScale: [%] of the letters in force.
    void arrange(Layout layout, int fontScale);
    void setThreshold(double newtons);   ///< of contact
    void addTerrainTool(QWidget* tool);  ///< to the terrain's title
    // Likewise TerrainLayout's, which see.
    QWidget* lower() const { return layout_->lower(); }
    void placeLower() { layout_->placeLower(); }
    void stackLower(bool stacked) { layout_->stackLower(stacked); }
    QWidget* decisions() const { return layout_->decisions(); }
    void placeDecisions() { layout_->placeDecisions(); }
    void setVerdictBeside(int columnWidth) { layout_->setVerdictBeside(columnWidth); }
    void allowTight(const ConsoleWindow& window) { layout_->allowTight(window); }
    bool isTight() const { return layout_->isTight(); }

    QSize
    minimumSizeHint() const override;  ///< whatever is shown, so that no text moves the window

    /// True once what was last shown includes the standing estimate.
    bool showsEstimate() const { return shownEstimate_; }

    AtemPanel* atemPanel() const { return atem_; }
    DrivePad* drivePad() const { return drive_; }
    EventList* events() const { return events_; }
    ForceBars* forces() const { return forces_; }
    QPushButton* forceUnitButton() const { return forceUnit_; }
    ProbeCard* probeCard() const { return probe_; }
    RobotReadout* readout() const { return readout_; }
    EstimateStrip* strip() const { return strip_; }
    TerrainProfileView* terrain() const { return terrain_; }
    VerdictStrip* verdict() const { return verdict_; }
    QPushButton* viewButton() const { return view_; }

signals:
    void tightened(bool tight);  ///< lower() has to leave, or may come back: placeLower()

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    Card* terrainCard();
    Card* forceCard();
    Card* robotCard();
    Card* eventCard();
    void showRobot(const TerrainViewState& viewState);
    void showAge(const TerrainViewState& viewState);
    void showEstimate(const TerrainViewState& viewState);
    void showPreview(const TerrainViewState& viewState);
    void showPose(const TerrainViewState& viewState);
    void showVerdict(const TerrainViewState& viewState);
    void showProbe(const TerrainViewState& viewState);
    void showProbeToAsk(const TerrainViewState& viewState);
    void showForcesAge(const TerrainViewState& viewState);
    void showThreshold();

    RobotModel robot_;
    double threshold_ = 0.0;
    std::optional<double> forcesAge_;  ///< [s] where it is said: they are not shown any more

    // Qt's parents own the widgets.
    VerdictStrip* verdict_ = nullptr;
    Card* terrainCard_ = nullptr;
    QPushButton* view_ = nullptr;
    EstimateStrip* strip_ = nullptr;
    TerrainProfileView* terrain_ = nullptr;
    AtemPanel* atem_ = nullptr;
    ProbeCard* probe_ = nullptr;
    ForceBars* forces_ = nullptr;
    ElidedLabel* forceLegend_ = nullptr;
    QPushButton* forceUnit_ = nullptr;
    QLabel* thresholdText_ = nullptr;
    RobotReadout* readout_ = nullptr;
    QLabel* robotAge_ = nullptr;
    bool numbersFresh_ = false;  ///< those of the robot, when they were shown last
    DrivePad* drive_ = nullptr;
    EventList* events_ = nullptr;
    TerrainLayout* layout_ = nullptr;

    std::uint64_t shownCount_ = 0;
    std::optional<TerrainEstimate> shown_, shownLive_, shownSecond_;
    std::optional<std::array<double, 3>> shownPose_;  ///< pitch, front, rear [rad]
    std::optional<Heights> shownTruth_;
    QString shownReason_;
    bool shownEstimate_ = false;
};

}  // namespace terratact
