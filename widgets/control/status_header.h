#pragma once

#include <QFrame>

class QBoxLayout;
class QPushButton;

namespace terratact {

class ArmingControl;
class ElidedLabel;
enum class Tone;

/// What is known of STOP.
struct StopViewState {
    enum class State {
        Ready,      ///< not asked for
        Sent,       ///< on its way: the robot has not said that it is stopped
        NotSent,    ///< asked for, but it could not leave
        Confirmed,  ///< the robot says that it is stopped
        Elsewhere,  ///< it goes to the console that opened this window, which says what becomes of it
        NoEffect,  ///< no command leaves from here, STOP neither
    };
    State state = State::Ready;
    double seconds = 0.0;  ///< [s] of Sent and NotSent: since it was asked for
    QString why{};         ///< of NotSent and NoEffect, in words
};

/// The dark strip at the top: where the data come from, how the link is, what the robot does, and STOP.
/// STOP acts on the press, needs no confirming and is never disabled; where it has no effect it looks so.  What does not fit beside it on one line stands on
/// two; changing texts move nothing.
class StatusHeader final : public QFrame {
    Q_OBJECT
public:
    explicit StatusHeader(QWidget* parent = nullptr);

    void setSource(const QString& name);
    void setLink(const QString& text, Tone tone, const QString& details = {});
    /// The bus: its state and load; empty: the source is none.  brief: what of that is to be seen where there is no room
    /// for all: of a doubt where others can spare it, of what is Bad in any case.
    void setBus(const QString& text, Tone tone, const QString& details, const QString& brief = {});
    /// unseen: how many of all nobody has acknowledged.
    void setAlarms(int unseen, int all);
    void
    setOverridden(const QString& what);  ///< a badge as long as a check is overridden; empty: none
    void setRobot(const QString& text, Tone tone);
    void setModel(const QString& text, Tone tone, const QString& details = {});
    /// The menu of what an estimate may cost.  names: one word each; lines: the same with cost and error.
    void setQualities(const QStringList& names, const QStringList& lines, int chosen);
    void setStop(const StopViewState& viewState);

    QString sourceName() const;
    QString linkText() const;
    ArmingControl* arming() const
    {
        return arming_;
    }  ///< to be hidden where nothing is to be armed
    QPushButton* stopButton() const { return stop_; }
    QPushButton* qualityButton() const { return quality_; }
    QPushButton* alarmsButton() const { return alarms_; }
    QPushButton* busButton() const { return bus_; }

    QSize minimumSizeHint() const override;  ///< on two lines
    int heightFor(int width) const;          ///< [px] it needs

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

signals:
    void stopPressed();
    void alarmsRequested();
    void busRequested();
    void qualityChosen(int index);

private:
    /// Leaves the model out where STOP needs its room, then the bus; what is Bad stays.
    void fit();
    void showBus(const QString& text);
    int stopWidth() const;   ///< [px] with the room before it
    int usualUpper() const;  ///< [px] of source, link and robot, without the bus
    void setLines(int lines);
    int oneLine() const;  ///< [px] wide, without model and bus
    QList<QWidget*> upper() const;
    QList<QWidget*> lower() const;
    QList<QWidget*> last() const;
    void keepRoom();                          ///< for every text there may be
    int busWidth(const QString& text) const;  ///< [px] for every load

    int lines_ = 0;
    QString busText_, busBrief_;
    Tone busTone_{};
    StopViewState::State stopState_ = StopViewState::State::Ready;
    QBoxLayout* first_ = nullptr;
    QBoxLayout* second_ = nullptr;
    ElidedLabel* source_ = nullptr;
    ElidedLabel* link_ = nullptr;
    ElidedLabel* robot_ = nullptr;
    ElidedLabel* overridden_ = nullptr;
    ElidedLabel* model_ = nullptr;
    QPushButton* alarms_ = nullptr;
    QPushButton* bus_ = nullptr;
    QPushButton* quality_ = nullptr;
    ArmingControl* arming_ = nullptr;
    QPushButton* stop_ = nullptr;
};

}  // namespace terratact
