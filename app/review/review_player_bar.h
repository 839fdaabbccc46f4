#pragma once

#include <QList>
#include <QWidget>
#include <functional>
#include <optional>

#include "app/review/review_player.h"
#include "core/log/review_moment.h"
#include "core/log/session_reader.h"
#include "widgets/signals/session_timeline.h"

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace terratact {

class KeyTable;

/// The timeline of a session under review and, below it, the controls of its player: play, step, speed, the cursors
/// A and B, a time to go to.  Holds the player; whoever shows the session listens to moved().
class ReviewPlayerBar final : public QWidget {
    Q_OBJECT
public:
    /// Both must outlive it.
    ReviewPlayerBar(const SessionReader& session, ReviewMoments& moments, QWidget* parent);

    const ReviewPlayer& player() const { return player_; }
    void goTo(double seconds);  ///< of the session
    void pause();
    void advance(double elapsed);  ///< lets that pass [s]
    void takeGrowth();             ///< the session has more; follows its end where that is wanted
    void setTimeline(const Timeline& timeline);
    void addTool(QWidget* tool);  ///< at the right end
    void addKeys(KeyTable& keys);

    SessionTimeline* timeline() const { return timeline_; }
    QLabel* differenceLabel() const { return difference_; }
    QLineEdit* positionEdit() const { return position_; }

    QSize minimumSizeHint() const override;  ///< without the end and the clock

signals:
    void moved();
    void started();  ///< to play
    void fieldLeft();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QPushButton* button(QHBoxLayout& row, const QString& text, const QString& name,
                        const QString& tip, std::function<void()> clicked);
    void addMoves(QHBoxLayout& row);
    void addSpeed(QHBoxLayout& row);
    void addCursors(QHBoxLayout& row);
    void addPosition(QHBoxLayout& row);
    void addPlayKeys(KeyTable& keys);
    void addStepKeys(KeyTable& keys);
    void showPlayer();
    void showClock();
    void resizeToFont();
    void play(bool backwards);
    void pauseAt(std::optional<SessionTime> time);
    void stepFrame(bool back);
    void stepLane(int lane, bool back);
    void stepTo(const QList<double>& times, bool back);
    QList<double> sceneTimes() const;
    QList<double> eventTimes() const;
    void speedUp(double factor);
    void setCursor(bool isA);
    void takePosition();

    const SessionReader& session_;
    ReviewMoments& moments_;
    ReviewPlayer player_;
    Timeline lanes_;

    // Qt's parents own the widgets.
    SessionTimeline* timeline_ = nullptr;
    QHBoxLayout* row_ = nullptr;
    QPushButton* play_ = nullptr;
    QPushButton* back_ = nullptr;
    QPushButton* loop_ = nullptr;
    QPushButton* follow_ = nullptr;
    QLabel* speed_ = nullptr;
    QLabel* of_ = nullptr;
    QLabel* difference_ = nullptr;
    QLineEdit* position_ = nullptr;
};

}  // namespace terratact
