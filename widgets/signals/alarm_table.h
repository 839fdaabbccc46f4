#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/atem/alarms.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace terratact {

/// The alarms, most urgent first, and what the operator does about them.  Each state has a shape and a word.
class AlarmTable final : public QWidget {
    Q_OBJECT
public:
    explicit AlarmTable(QWidget* parent = nullptr);

    /// now: [s] on the alarms' clock.  silentFor: [s].
    void setAlarms(const std::vector<Alarm>& alarms, double now, double silentFor);
    void setSoundOn(bool on);
    void setSoundTrouble(const QString& why);  ///< empty: it sounds, as far as is known

    QTableWidget* table() const { return table_; }
    QPushButton* acknowledgeButton() const { return acknowledge_; }
    QPushButton* acknowledgeAllButton() const { return all_; }
    QPushButton* silenceButton(int minutes) const { return minutes == 1 ? one_ : two_; }
    QCheckBox* soundBox() const { return sound_; }
    QPushButton* trySoundButton() const { return try_; }

signals:
    void acknowledged(const QString& id);
    void allAcknowledged();
    void silenced(double seconds);
    void soundWanted(bool on);
    void soundTried();

protected:
    void changeEvent(QEvent* event) override;

private:
    void resizeToFont();
    void put(int row, const Alarm& alarm, double now);
    void say(double silentFor);
    QString chosen() const;  ///< the id of the chosen row; may be empty
    void offer();            ///< what can be done now

    QTableWidget* table_ = nullptr;
    QLabel* nothing_ = nullptr;
    QLabel* silence_ = nullptr;
    QPushButton *acknowledge_ = nullptr, *all_ = nullptr, *one_ = nullptr, *two_ = nullptr,
                *try_ = nullptr;
    QLabel* soundTrouble_ = nullptr;
    QCheckBox* sound_ = nullptr;
};

}  // namespace terratact
