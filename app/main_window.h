#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "app/acquisition.h"
#include "app/estimator_worker.h"
#include "app/exploration.h"
#include "app/model_trainer.h"
#include "app/panel_control.h"
#include "core/eval/tradeoff.h"

class QAction;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace terratact {

class ArmingControl;
class AtemPanel;
class DrivePad;
class EstimateStrip;
class EventList;
class ForceBars;
class NavigationRail;
class Page;
class ProbeCard;
class RobotReadout;
class StatusHeader;
class NumbersPage;
class TrainingPage;
class TerrainProfileView;
class VerdictStrip;

/// The operator's console: lays the widgets out, shows them the newest state every 40 ms at most and passes on
/// what the operator does.  It owns the source and everything that runs.
class MainWindow final : public QWidget {
    Q_OBJECT
public:
    struct Options {
        RobotModel robot;
        std::unique_ptr<MeasurementSource> source;
        CanSource* link = nullptr;             ///< the source again, where it is a bus
        std::unique_ptr<OperatorPanel> panel;  ///< null: there is none
        ModelLoader model;
        std::string modelPath;  ///< what `model` loads, for the page that compares models
        TrainingLoad training = politeLoad();
        Exploration::Options exploration;
        std::vector<PresetCost> presets;  ///< as `terratact tradeoff` measured them; may be empty
    };
    explicit MainWindow(Options options);
    ~MainWindow() override;

    Exploration& exploration() { return *exploration_; }
    const Acquisition& acquisition() const { return *acquisition_; }
    /// True once what was last drawn includes the standing estimate.
    bool showsEstimate() const { return shownEstimate_; }
    QString modelTrouble() const { return modelTrouble_; }

    CanSource* link() const { return link_; }
    AtemPanel* atemPanel() const { return atem_; }
    DrivePad* drivePad() const { return drive_; }
    EventList* events() const { return events_; }
    ForceBars* forces() const { return forces_; }
    ProbeCard* probeCard() const { return probe_; }
    RobotReadout* readout() const { return readout_; }
    StatusHeader* header() const { return header_; }
    TerrainProfileView* terrain() const { return terrain_; }
    EstimateStrip* strip() const { return strip_; }
    NavigationRail* rail() const { return rail_; }
    NumbersPage* numbers() const { return numbers_; }
    TrainingPage* training() const { return training_; }
    VerdictStrip* verdict() const { return verdict_; }
    QPushButton* viewButton() const { return view_; }

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void build();
    QWidget* terrainPage();
    void addPage(Page* page, const QString& name, Qt::Key key, const QString& tip);
    void connectAll();
    void look();  ///< at telemetry, panel and estimator, every 10 ms; draws at 25 Hz
    void redraw(double now);
    void showLink(double now, const std::optional<Received>& latest);
    void showArming(double now);
    QString
    panelForbids(double now) const;  ///< why nothing may be set in motion; empty: it does not
    void tickPanel(double now);
    void releaseStop();
    void showTerrain(const std::optional<Received>& latest);
    void showVerdict();
    void showProbe();
    void addTraining(const Options& options);
    void offerViews();
    void showHelp();
    void offerQualities(const std::vector<PresetCost>& presets);
    bool keyPressed(int key);
    bool keyReleased(int key);

    RobotModel robot_;
    std::unique_ptr<MeasurementSource> source_;
    CanSource* link_;  ///< null where the source is no bus
    std::unique_ptr<Acquisition> acquisition_;
    std::unique_ptr<EstimatorWorker> worker_;
    std::unique_ptr<Exploration> exploration_;
    std::unique_ptr<PanelControl> panel_;  ///< may be null
    QTimer look_;
    std::optional<Received> latest_;
    double redrawn_ = 0.0;  ///< [s] steady clock

    // Qt's parents own the widgets.
    StatusHeader* header_ = nullptr;
    NavigationRail* rail_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    QLabel* banner_ = nullptr;
    QLabel* help_ = nullptr;
    VerdictStrip* verdict_ = nullptr;
    NumbersPage* numbers_ = nullptr;
    TrainingPage* training_ = nullptr;
    QPushButton* view_ = nullptr;
    QAction* drawsAction_ = nullptr;
    EstimateStrip* strip_ = nullptr;
    TerrainProfileView* terrain_ = nullptr;
    AtemPanel* atem_ = nullptr;
    ProbeCard* probe_ = nullptr;
    ForceBars* forces_ = nullptr;
    RobotReadout* readout_ = nullptr;
    QLabel* robotAge_ = nullptr;
    DrivePad* drive_ = nullptr;
    EventList* events_ = nullptr;

    std::uint64_t shownCount_ = 0;
    std::optional<TerrainEstimate> shown_, shownLive_;
    std::optional<TerrainEstimate> shownSecond_;
    std::optional<Verdict> shownVerdict_;
    QString shownReason_;
    bool shownEstimate_ = false;
    bool linkWasAlive_ = false;
    ArmingPhase armingWas_ = ArmingPhase::Disarmed;
    double linkShownAt_ = 0.0;
    double worstAge_ = 0.0;
    QString modelTrouble_;
};

}  // namespace terratact
