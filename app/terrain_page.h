#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "app/preferences.h"
#include "core/atem/atem_machine.h"
#include "core/infer/estimate.h"
#include "core/infer/ghost.h"
#include "core/infer/verdict.h"
#include "core/robot/robot_model.h"
#include "widgets/atem_panel.h"
#include "widgets/force_bars.h"
#include "widgets/probe_card.h"
#include "widgets/robot_readout.h"

class QBoxLayout;
class QLabel;
class QPushButton;
class QSpacerItem;

namespace terratact {

class Card;
class ConsoleWindow;
class DrivePad;
class ElidedLabel;
class EstimateStrip;
class EventList;
class TerrainProfileView;
class VerdictStrip;

/// What there is to see of the robot and its exploration at one time.  What is pointed to is used in setSight() only;
/// null: there is none.
struct TerrainSight {
    double now = 0.0;    ///< [s] on the clock of the telemetry
    bool ended = false;  ///< nothing more will come

    const Measurement* measurement = nullptr;  ///< the newest
    double age = 0.0;                          ///< [s] of it
    std::optional<RobotReadout::Ages> ages{};  ///< of its values; empty: all are of that age
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
/// fill it with a TerrainSight and listen to its widgets.
class TerrainPage final : public QWidget {
    Q_OBJECT
public:
    explicit TerrainPage(RobotModel robot, QWidget* parent = nullptr);

    void setSight(const TerrainSight& sight);
    /// fontScale: [%] of the letters in force.
    void arrange(Layout layout, int fontScale);
    void setThreshold(double newtons);  ///< of contact
    /// Forces, robot and events, below the terrain; whoever takes them into a layout of its own gives them back so.
    QWidget* lower() const { return lowerPanel_; }
    void placeLower();
    void stackLower(bool stacked);  ///< robot and events one above the other: half as wide
    /// Likewise exploring and the arm, beside the terrain.
    QWidget* decisions() const { return decisions_; }
    void placeDecisions();
    /// Verdict and decisions in a column beside the terrain, which gets all the height; columnWidth: at 100 %.
    void setVerdictBeside(int columnWidth);
    void addTerrainTool(QWidget* tool);  ///< to the terrain's title
    /// From now on, where there is no room for the cards below the terrain, they leave it for somebody else's place
    /// (tightened()), and what is to be decided stands in a narrow column.  A banner of the window, the page's own,
    /// moves no card: its line is the terrain's.
    void allowTight(const ConsoleWindow& window);
    bool isTight() const { return tight_; }

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
    void showRobot(const TerrainSight& sight);
    void showAge(const TerrainSight& sight);
    void showEstimate(const TerrainSight& sight);
    void showPreview(const TerrainSight& sight);
    void showPose(const TerrainSight& sight);
    void showVerdict(const TerrainSight& sight);
    void showProbe(const TerrainSight& sight);
    void showForcesAge(const TerrainSight& sight);
    void showThreshold();
    void fit();
    void setTight(bool tight);
    void setColumn();
    void placeVerdict();
    void share();
    QSize needs(bool tight);

    RobotModel robot_;
    Layout layout_ = Layout::Probe;
    int fontScale_ = 100;
    bool verdictBeside_ = false;
    bool stacked_ = false;                   ///< robot and events
    const ConsoleWindow* window_ = nullptr;  ///< null: it does not tighten
    bool tight_ = false;
    bool measures_ = false;          ///< arranged for a moment only
    QSize roomyNeeds_, tightNeeds_;  ///< [px]
    int columnWidth_ = 404;          ///< [px] at 100 %
    double threshold_ = 0.0;
    std::optional<double> forcesAge_;  ///< [s] where it is said: they are not shown any more

    // Qt's parents own the widgets.
    VerdictStrip* verdict_ = nullptr;
    Card* terrainCard_ = nullptr;
    Card* robotCard_ = nullptr;
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
    QBoxLayout* ground_ = nullptr;     ///< verdict and terrain
    QBoxLayout* rows_ = nullptr;       ///< terrain and decisions, the cards below
    QBoxLayout* upper_ = nullptr;      ///< the terrain and the decisions
    QBoxLayout* column_ = nullptr;     ///< of the decisions
    QSpacerItem* question_ = nullptr;  ///< the height that a probe's question needs, beside them
    QWidget* decisions_ = nullptr;
    QBoxLayout* decide_ = nullptr;  ///< of them
    QWidget* lowerPanel_ = nullptr;
    QBoxLayout* lower_ = nullptr;   ///< forces, and beside them
    QBoxLayout* recent_ = nullptr;  ///< robot and events

    std::uint64_t shownCount_ = 0;
    std::optional<TerrainEstimate> shown_, shownLive_, shownSecond_;
    std::optional<std::array<double, 3>> shownPose_;  ///< pitch, front, rear [rad]
    std::optional<Heights> shownTruth_;
    QString shownReason_;
    bool shownEstimate_ = false;
};

}  // namespace terratact
