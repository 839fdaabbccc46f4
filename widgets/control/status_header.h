#pragma once

#include <QFrame>

#include "app/display/stop_view_state.h"
#include "app/display/tone.h"

class QBoxLayout;
class QPushButton;

namespace terratact {

class ArmingControl;
class ElidedLabel;

/// The dark strip at the top: data source, link, robot activity and STOP. STOP acts on the press without confirmation
/// and is never disabled; its style shows when it has no effect. Items that do not fit beside STOP on one line use two
/// lines. Changing texts never move items.
class StatusHeader final : public QFrame {
    Q_OBJECT
public:
    explicit StatusHeader(QWidget* parent = nullptr);

    void setSource(const QString& name);
    void setLink(const QString& text, Tone tone, const QString& details = {});
    /// Sets the bus state and load; empty: the source has no bus. brief: short text for narrow widths. A doubtful bus
    /// shows it if other items leave room, a Bad bus always.
    void setBus(const QString& text, Tone tone, const QString& details, const QString& brief = {});
    /// unseen: number of unacknowledged alarms.
    void setAlarms(int unseen, int all);
    /// Shows a badge while a check is overridden; empty: no badge.
    void setOverridden(const QString& what);
    void setRobot(const QString& text, Tone tone);
    void setModel(const QString& text, Tone tone, const QString& details = {});
    /// Sets the quality menu. names: one word per preset; lines: the same with cost and error.
    void setQualities(const QStringList& names, const QStringList& lines, int chosen);
    void setStop(const StopViewState& viewState);

    QString sourceName() const;
    QString linkText() const;
    ArmingControl* arming() const { return arming_; }  ///< hidden if nothing can be armed
    QPushButton* stopButton() const { return stop_; }
    QPushButton* qualityButton() const { return quality_; }
    QPushButton* alarmsButton() const { return alarms_; }
    QPushButton* busButton() const { return bus_; }

    QSize minimumSizeHint() const override;  ///< size with two lines
    int heightFor(int width) const;          ///< [px] height needed at this width

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

signals:
    void stopPressed();
    void alarmsRequested();
    void busRequested();
    void qualityChosen(int index);

private:
    /// Hides first the model, then the bus, if STOP needs their room. A Bad bus stays.
    void fit();
    void showBus(const QString& text);
    int stopWidth() const;   ///< [px] width of STOP with the gap before it
    int usualUpper() const;  ///< [px] width of source, link and robot, without the bus
    void setLines(int lines);
    int oneLine() const;  ///< [px] width of one line without model and bus
    QList<QWidget*> upper() const;
    QList<QWidget*> lower() const;
    QList<QWidget*> last() const;
    void keepRoom();                          ///< reserves room for every possible text
    int busWidth(const QString& text) const;  ///< [px] width for any load

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
