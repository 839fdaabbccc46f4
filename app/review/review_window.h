#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "app/plotting/session_signals.h"
#include "app/recording/session_indexer.h"
#include "app/review/review_display.h"
#include "app/review/review_note_field.h"
#include "app/review/review_player_bar.h"
#include "app/review/review_view_state.h"
#include "app/shell/console_window.h"
#include "app/shell/preferences/preference_store.h"
#include "core/log/review_moment.h"
#include "core/robot/robot_model.h"

class QLabel;
class QScrollArea;

namespace terratact {

class NumbersPage;
class PlotsPage;
class ReviewEventsPage;
class ReviewExportDialog;
class ReviewSignalsPage;
class TerrainPage;
class WhatIfPage;
struct ExportViewState;

/// A recorded session as the console showed it: the terrain page at any time of the file, with a timeline. It has no
/// source, so it cannot command a robot. The file is only read; notes are kept beside it.
class ReviewWindow final : public ConsoleWindow {
    Q_OBJECT
public:
    struct Options {
        SessionReader session;
        RobotModel robot;
        QStringList models{};  ///< model files for What if, and to search for the recorded model
        std::unique_ptr<PreferenceStore> preferences{};
    };
    explicit ReviewWindow(Options options);
    ~ReviewWindow() override;

    void goTo(double seconds) { player_->goTo(seconds); }  ///< [s] of the session
    /// Advances playback and polls the file for growth. elapsed: [s]
    void poll(double elapsed);

    PreferenceStore& preferences() { return *preferences_; }
    const ReviewPlayer& player() const { return player_->player(); }
    const ReviewMoment& moment() const { return moment_; }
    const SessionReader& session() const { return session_; }
    const std::vector<ReviewNote>& notes() const { return note_->notes(); }
    TerrainPage* terrainPage() const { return terrain_; }
    NumbersPage* numbers() const { return numbers_; }
    ReviewEventsPage* events() const { return events_; }
    WhatIfPage* whatIf() const { return whatIf_; }
    ReviewSignalsPage* signalsPage() const { return signals_; }
    PlotsPage* plotsPage() const { return plots_; }
    const SessionSignals& plotted() const { return plotted_; }
    SessionTimeline* timeline() const { return player_->timeline(); }
    QLabel* stateLabel() const { return state_; }
    QLabel* damageLabel() const { return damage_; }
    QLabel* differenceLabel() const { return player_->differenceLabel(); }
    QLineEdit* positionEdit() const { return player_->positionEdit(); }
    QLineEdit* noteEdit() const { return note_; }
    ReviewExportDialog* exportDialog() const { return export_; }  ///< null before the first export
    bool surveyed() const { return surveyedAll_; }

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void arrange() override;

private:
    void buildHeader();
    void addPages(QStringList models);
    void addTools();
    void addPlayer();
    void connectAll();
    void defineKeys();
    void showMoment();
    void showTerrain();
    void showState();
    void place();  ///< places cards that do not fit beside the terrain on the robot's page
    void forbidCommands();
    void applyPreferences(const Preferences& before);
    void loadTimeline();
    void followSession();
    void addNote();
    void noteTaken();
    void open();
    std::function<void(const QString& why)> notOpened();
    ExportViewState exportViewState() const;
    void exportShown();

    SessionReader session_;
    RobotModel robot_;
    std::unique_ptr<PreferenceStore> preferences_;
    ReviewMoments moments_;
    ReviewViewState viewStates_;
    std::optional<ReviewDisplay> display_;  ///< set once its widgets exist
    ReviewMoment moment_;
    SessionIndexer indexer_;
    SessionSignals plotted_;
    std::uint64_t surveyVersion_ = 0;
    bool surveyedAll_ = false;
    bool grows_ = false;  ///< rows were committed within the last seconds
    double sinceRefresh_ = 0.0, sinceGrowth_ = 0.0;  ///< [s]
    QString trouble_;                                ///< last error of notes, files or exports
    qsizetype damagedPlaces_ = 0;
    QTimer pollTimer_;
    QElapsedTimer sinceLook_;

    // Qt's parents own the widgets.
    QLabel* state_ = nullptr;
    QLabel* damage_ = nullptr;
    TerrainPage* terrain_ = nullptr;
    QScrollArea* robotPage_ = nullptr;
    NumbersPage* numbers_ = nullptr;
    ReviewEventsPage* events_ = nullptr;
    WhatIfPage* whatIf_ = nullptr;
    ReviewSignalsPage* signals_ = nullptr;
    PlotsPage* plots_ = nullptr;
    ReviewPlayerBar* player_ = nullptr;
    ReviewNoteField* note_ = nullptr;
    ReviewExportDialog* export_ = nullptr;
};

}  // namespace terratact
