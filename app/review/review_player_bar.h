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

/// The timeline of a reviewed session with its player controls: play, step, speed, cursors, and go to a time. It owns
/// the player; the window listens to moved().
class ReviewPlayerBar final : public QWidget {
    Q_OBJECT
public:
    /// Session and moments must outlive the bar.
    ReviewPlayerBar(const SessionReader& session, ReviewMoments& moments, QWidget* parent);

    const ReviewPlayer& player() const { return player_; }
    void goTo(double seconds);  ///< [s] of the session
    void pause();
    void advance(double elapsed);  ///< advances playback by `elapsed` [s]
    void addGrowth();  ///< call after the session has grown; follows its end if following
    void setTimeline(const Timeline& timeline);
    void addTool(QWidget* tool);  ///< adds a tool at the right end
    void addKeys(KeyTable& keys);

    SessionTimeline* timeline() const { return timeline_; }
    QLabel* differenceLabel() const { return difference_; }
    QLineEdit* positionEdit() const { return position_; }

    QSize minimumSizeHint() const override;  ///< size without the end time and the clock

signals:
    void moved();
    void started();  ///< playback has started
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
    void goToEntered();

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
