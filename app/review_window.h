#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "app/key_table.h"
#include "app/preference_store.h"
#include "app/review_notes.h"
#include "app/review_player.h"
#include "app/review_timeline.h"
#include "app/session_surveyor.h"
#include "core/log/review_moment.h"
#include "core/robot/robot_model.h"

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace terratact {

class NavigationRail;
class NumbersPage;
class ReviewEventsPage;
class SessionTimeline;
class StatusHeader;
class TerrainPage;
class WhatIfPage;

/// A recorded session as the console showed it: the console's page of the terrain at any time of the file, with a
/// timeline to move in it.  There is no source behind it, so nothing in it can command a robot.  The file is only
/// read; notes are kept beside it.
class ReviewWindow final : public QWidget {
    Q_OBJECT
public:
    struct Options {
        SessionReader session;
        RobotModel robot;
        QStringList
            models{};  ///< files to try what-if with; the recorded one is looked for among them
        std::unique_ptr<PreferenceStore> preferences{};
    };
    explicit ReviewWindow(Options options);
    ~ReviewWindow() override;

    void goTo(double seconds);  ///< of the session
    /// Lets time pass: plays, and looks whether the session has grown.  elapsed: [s]
    void look(double elapsed);

    const ReviewPlayer& player() const { return player_; }
    const ReviewMoment& moment() const { return moment_; }
    const SessionReader& session() const { return session_; }
    const KeyTable& keys() const { return keys_; }
    const std::vector<ReviewNote>& notes() const { return notes_; }
    StatusHeader* header() const { return header_; }
    NavigationRail* rail() const { return rail_; }
    TerrainPage* terrainPage() const { return terrain_; }
    NumbersPage* numbers() const { return numbers_; }
    ReviewEventsPage* events() const { return events_; }
    WhatIfPage* whatIf() const { return whatIf_; }
    SessionTimeline* timeline() const { return timeline_; }
    QLabel* stateLabel() const { return state_; }
    QLabel* damageLabel() const { return damage_; }
    QLabel* differenceLabel() const { return difference_; }
    QLineEdit* positionEdit() const { return position_; }
    QLineEdit* noteEdit() const { return note_; }
    bool surveyed() const { return surveyedAll_; }

    /// Writes the terrain's picture; the suffix says which: png, svg, pdf.  Why it could not; empty: it is there.
    QString savePicture(const QString& path);
    /// Writes the numbers of this time and of its estimate as CSV.
    QString saveNumbers(const QString& path);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    QWidget* transport();
    QPushButton* button(QHBoxLayout& row, const QString& text, const QString& name,
                        const QString& tip, std::function<void()> clicked);
    void defineKeys();
    void definePlayKeys();
    void defineStepKeys();
    void showMoment();
    void showHeader();
    void showTerrain();
    void showState();
    void showPlayer();
    void showEvents();
    void placeLower();  ///< in a window that is not high they have a page of their own
    void forbidCommands();
    void applyPreferences(const Preferences& before);
    void loadTimeline();
    void followSession();
    void play(bool backwards);
    void pauseAt(std::optional<SessionTime> time);
    void stepLane(int lane, bool back);
    void stepTo(const QList<double>& times, bool back);
    QList<double> eventTimes() const;
    void setCursor(bool isA);
    void addNote();
    void takeNote();
    void takePosition();
    void open();
    void exportShown();
    void showHelp();

    SessionReader session_;
    RobotModel robot_;
    std::unique_ptr<PreferenceStore> preferences_;
    ReviewMoments moments_;
    ReviewMoment moment_;
    ReviewPlayer player_;
    SessionSurveyor surveyor_;
    std::uint64_t surveyVersion_ = 0;
    bool surveyedAll_ = false;
    bool grows_ = false;  ///< something was committed within the last seconds
    double sinceRefresh_ = 0.0, sinceGrowth_ = 0.0;  ///< [s]
    std::uint64_t shows_ = 0;
    std::int64_t listed_ = -1;     ///< the newest event in the list
    std::optional<double> limit_;  ///< [m] of an obstacle, where the reviewer asks for another
    std::vector<ReviewNote> notes_;
    QString notesTrouble_;
    Timeline lanes_;
    KeyTable keys_;
    QTimer look_;
    QElapsedTimer sinceLook_;

    // Qt's parents own the widgets.
    StatusHeader* header_ = nullptr;
    QLabel* state_ = nullptr;
    QLabel* damage_ = nullptr;
    NavigationRail* rail_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    TerrainPage* terrain_ = nullptr;
    QWidget* robotPage_ = nullptr;
    NumbersPage* numbers_ = nullptr;
    ReviewEventsPage* events_ = nullptr;
    WhatIfPage* whatIf_ = nullptr;
    SessionTimeline* timeline_ = nullptr;
    QPushButton* playButton_ = nullptr;
    QPushButton* backButton_ = nullptr;
    QPushButton* loop_ = nullptr;
    QPushButton* follow_ = nullptr;
    QLabel* speed_ = nullptr;
    QLabel* of_ = nullptr;
    QLabel* difference_ = nullptr;
    QLineEdit* position_ = nullptr;
    QLineEdit* note_ = nullptr;
    QLabel* help_ = nullptr;
};

}  // namespace terratact
