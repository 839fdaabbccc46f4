#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/console/connection/link_status.h"
#include "app/console/live_view_state.h"
#include "app/console/pages/diagnostics_page.h"
#include "app/console/past/recording_display.h"
#include "app/console/probe_notice.h"
#include "app/console/shared_stop.h"
#include "app/console/stop_display.h"
#include "app/display/translated.h"
#include "app/link/acquisition.h"
#include "app/link/robot_moment.h"
#include "app/mission/console_alarms.h"
#include "app/mission/estimator_worker.h"
#include "app/mission/exploration.h"
#include "app/mission/model_choice.h"
#include "app/mission/model_trainer.h"
#include "app/mission/panel_control.h"
#include "app/modelling/tradeoff_csv.h"
#include "app/pages/terrain_page.h"
#include "app/recording/session_recorder.h"
#include "app/shell/console_window.h"
#include "app/shell/loop_meter.h"
#include "app/shell/preferences/preference_store.h"
#include "app/shell/short_notice.h"
#include "core/atem/contact_cue.h"
#include "core/atem/stall_watch.h"
#include "core/base/message.h"
#include "drivers/gamepad.h"

class QLabel;
class QPushButton;

namespace terratact {

class AlarmsPage;
class LivePlots;
class LogReplay;
class ReplayBar;
class SecondView;
struct SnapshotFiles;
class SnapshotNote;
class SnapshotWriter;
class SessionEventLogger;
class ArmingControl;
class GamepadControl;
class GamepadPage;
class ConnectWindow;
struct ConnectionWish;
class SettingsFilesWindow;
class SettingsPage;
class SignalsPage;
class NumbersPage;
class PlotsPage;
class HistoryControl;
class ProfileMenu;
class TrainingPage;

/// The operator's console. It arranges the widgets and forwards the operator's actions. New telemetry is shown at up to
/// 25 Hz, values that depend on time every 60 ms. It owns the source and all running parts.
class MainWindow final : public ConsoleWindow {
    Q_OBJECT
public:
    struct Options {
        RobotModel robot;
        QString robotDetails{};  ///< file and hash
        std::unique_ptr<MeasurementSource> source;
        CanSource* link = nullptr;             ///< the source, if it is a bus
        LogReplay* replay = nullptr;           ///< replay of the source, if it is a log
        std::unique_ptr<OperatorPanel> panel;  ///< null: no panel
        std::unique_ptr<Gamepad> gamepad{};    ///< null: gamepads are not read
        ModelLoader model;
        std::string modelPath;  ///< file that `model` loads, for comparing models
        TrainingLoad training = politeLoad();
        Exploration::Options exploration;
        std::unique_ptr<AlarmSound> alarmSound = desktopBeep();
        std::unique_ptr<PreferenceStore> preferences;  ///< null: defaults, and nothing is saved
        std::shared_ptr<SessionRecorder> recorder{};   ///< null: no recording
        PresetTable presets{};                         ///< measured by `terratact tradeoff`
        /// Monotonic clock [s] of the watch for a frozen window, and of the gamepad.
        std::function<double()> inputClock = steadyNow;
    };
    explicit MainWindow(Options options);
    ~MainWindow() override;

    Exploration& exploration() { return *exploration_; }
    const Acquisition& acquisition() const { return *acquisition_; }
    /// Returns true once the last painted frame includes the present estimate.
    bool showsEstimate() const { return terrainPage_->showsEstimate(); }
    QString modelTrouble() const { return translated(exploration_->estimation().model().trouble); }

    PreferenceStore& preferences() { return *preferences_; }
    CanSource* link() const { return link_; }
    AtemPanel* atemPanel() const { return terrainPage_->atemPanel(); }
    DrivePad* drivePad() const { return terrainPage_->drivePad(); }
    EventList* events() const { return terrainPage_->events(); }
    ForceBars* forces() const { return terrainPage_->forces(); }
    QPushButton* forceUnitButton() const { return terrainPage_->forceUnitButton(); }
    ProbeCard* probeCard() const { return terrainPage_->probeCard(); }
    RobotReadout* readout() const { return terrainPage_->readout(); }
    TerrainProfileView* terrain() const { return terrainPage_->terrain(); }
    EstimateStrip* strip() const { return terrainPage_->strip(); }
    NumbersPage* numbers() const { return numbers_; }
    SettingsPage* settings() const { return settings_; }
    SettingsFilesWindow* settingsFiles() const { return settingsFiles_; }
    ConnectWindow* connectWindow() const { return connectWindow_; }
    TrainingPage* training() const { return training_; }
    GamepadPage* gamepadPage() const { return gamepadPage_; }
    VerdictStrip* verdict() const { return terrainPage_->verdict(); }
    QPushButton* viewButton() const { return terrainPage_->viewButton(); }
    ConsoleAlarms& alarms() { return *alarms_; }
    const LoopMeter& meter() const { return meter_; }
    void restartMeter();
    /// Reports why a key or button had no effect: as an event and in a temporary banner.
    void showWhyNot(const Message& text);
    /// Requests a probe of the bin shown in detail, else of the best bin.
    void askProbe();
    void addPictureKeys(KeyTable& keys);  ///< keys of the terrain picture
    void addStripExport();
    /// Saves the window's picture and the numbers of this moment, and asks for a note.
    void takeSnapshot();
    void toggleSecondView();
    SecondView* secondView() const { return secondView_; }        ///< null before its first use
    SnapshotNote* snapshotNote() const { return snapshotNote_; }  ///< null before its first use
    AlarmsPage* alarmsPage() const { return alarmsPage_; }
    SignalsPage* signalsPage() const { return signalsPage_; }
    DiagnosticsPage* diagnosticsPage() const { return diagnosticsPage_; }
    PlotsPage* plotsPage() const;
    HistoryControl& history() const { return *history_; }

signals:
    /// Another robot or language was chosen, so the window must be rebuilt. Motion commanded by this console has ended.
    void reopenWanted();
    /// The operator chose another connection. Motion commanded by this console has ended.
    void connectionWanted(const terratact::ConnectionWish& wish);

protected:
    /// The window of an armed robot closes only after a second request, or by a signal.
    void closeEvent(QCloseEvent* event) override;
    bool event(QEvent* event) override;

private:
    void build(const Options& options);
    void addPages(const Options& options);
    void showAlarms(const LinkAccount& link);
    void showRecording(const LinkAccount& link);
    void notice(const Message& text, EventSeverity severity, EventPlace place);
    void showPanelLost();
    void mark();
    void connectAll();
    void connectHeader();
    void connectExploration();
    void log(const Message& text, EventSeverity severity);  ///< adds an event
    /// Adds an event that the exploration panel shows, too.
    void logState(const Message& text, EventSeverity severity);
    void connectWorker();
    /// Polls telemetry, panel and estimator: on new telemetry and estimates, and every 10 ms. It draws at up to 25 Hz.
    /// Shows what is new: main_window_tick.cpp. An estimate goes to TerrainPage::showEstimate().
    void poll();
    void pollSoon();  ///< from any thread
    void logStall(double seconds);
    void redraw();
    void showTerrain();
    void showSecondView(const TerrainViewState& viewState);
    void snapshotWritten(const SnapshotFiles& files, const QString& trouble);
    void noteSnapshot(const SnapshotFiles& files, const QString& note);
    bool isRecording(const SnapshotFiles& files) const;  ///< the session beside the files
    void soundContact(const FlipperContacts& contacts, const Measurement* measurement);
    void tickPanel(double now);
    void releaseStop();
    void connectStop();
    void addTraining(const Options& options);
    void addGamepad(std::unique_ptr<Gamepad> gamepad);
    void addHistory();
    bool asksInPast();
    void showHistory(TerrainViewState& viewState);
    /// frozen: the window has just been frozen, so the gamepad must be released first.
    void pollGamepad(double now, bool frozen);
    void addWindowKeys(KeyTable& keys);
    void open();
    void showSettingsFiles();
    void showConnect();
    std::optional<Message> whyNotChangingAll() const;
    std::function<void(const QString& why)> notOpened();
    void defineKeys();
    void applyPreferences(const Preferences& before);
    /// Applies theme and letter size, which blocks this window for up to 0.1 s. That would disarm an armed robot that
    /// moves, so the change waits until the robot stands.
    void showLook();
    /// Arranges the terrain page for the current layout and font scale.
    void arrange() override;
    int arrangement() const override;
    /// Places forces, robot and events on the terrain page, or on a page of their own.
    void placeCards();
    void showCards();  ///< shows model and robot on the settings page
    void leave();
    void reopen();
    void applyRobot(const QString& path);
    std::optional<Message> whyNotReopening() const;  ///< empty: the window may be rebuilt
    void offerQualities();  ///< offers the presets, with costs if measured with this model

    std::unique_ptr<PreferenceStore> preferences_;
    PresetTable presets_;
    RobotModel robot_;
    std::unique_ptr<MeasurementSource> source_;
    CanSource* link_;                        ///< null if the source has no bus
    bool lookWaits_ = false;                 ///< showLook() waits until the robot stands
    std::atomic<bool> pollPending_ = false;  ///< a poll() requested by pollSoon() is pending
    std::unique_ptr<Acquisition> acquisition_;
    std::unique_ptr<EstimatorWorker> worker_;
    std::unique_ptr<Exploration> exploration_;
    std::unique_ptr<ModelChoice> models_;
    std::unique_ptr<PanelControl> panel_;      ///< may be null
    std::unique_ptr<GamepadControl> gamepad_;  ///< may be null
    std::unique_ptr<HistoryControl> history_;
    std::unique_ptr<LinkStatus> linkStatus_;
    std::unique_ptr<RecordingDisplay> recordingDisplay_;
    std::unique_ptr<StopDisplay> stopDisplay_;
    std::unique_ptr<ShortNotice> notice_;
    bool wasArmed_ = false;
    std::unique_ptr<ProbeNotice> probeNotice_;
    std::unique_ptr<SharedStop> sharedStop_;
    std::unique_ptr<ConsoleAlarms> alarms_;
    ContactCue contactCue_;
    std::shared_ptr<SessionRecorder> recorder_;        ///< may be null
    std::unique_ptr<SessionEventLogger> eventLogger_;  ///< may be null
    std::unique_ptr<LiveViewState> viewStates_;
    std::unique_ptr<LivePlots> plots_;
    LoopMeter meter_;
    double prepared_ = 0.0;    ///< [s] preparation time of the frame to be painted
    double newestIn_ = -1.0;   ///< [s] arrival of the new telemetry in that frame
    std::uint64_t drawn_ = 0;  ///< Received::count of the last drawn sample
    QTimer pollTimer_;
    RobotMoment moment_;  ///< of the last tick: everything is drawn from it
    StallWatch stalls_;   ///< stalls of poll()
    std::function<double()> inputClock_;
    double redrawn_ = 0.0;        ///< [s] steady clock
    double numbersShown_ = 0.0;   ///< [s] time of the last update of the robot's numbers
    double closeRefused_ = -1e9;  ///< [s] time of the last refused request to close

    // Qt's parents own the widgets.
    QWidget* cardsPage_ = nullptr;
    QLabel* panelLost_ = nullptr;        ///< a banner
    ElidedLabel* pastBanner_ = nullptr;  ///< made at first use
    NumbersPage* numbers_ = nullptr;
    SettingsPage* settings_ = nullptr;
    ConnectWindow* connectWindow_ = nullptr;        ///< null until first requested
    SettingsFilesWindow* settingsFiles_ = nullptr;  ///< null until first requested
    GamepadPage* gamepadPage_ = nullptr;
    TerrainPage* terrainPage_ = nullptr;
    TrainingPage* training_ = nullptr;
    QPushButton* recording_ = nullptr;
    ReplayBar* replayBar_ = nullptr;  ///< may be null
    ProfileMenu* profileMenu_ = nullptr;
    AlarmsPage* alarmsPage_ = nullptr;
    SignalsPage* signalsPage_ = nullptr;
    DiagnosticsPage* diagnosticsPage_ = nullptr;
    SecondView* secondView_ = nullptr;
    SnapshotNote* snapshotNote_ = nullptr;
    SnapshotWriter* snapshotWriter_ = nullptr;
    QString robotDetails_;
};

}  // namespace terratact
