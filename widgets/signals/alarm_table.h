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

/// Table of alarms, most urgent first, with the operator's actions. Each state has its own shape and word.
class AlarmTable final : public QWidget {
    Q_OBJECT
public:
    explicit AlarmTable(QWidget* parent = nullptr);

    /// now: time on the alarms' clock [s]. silentFor: remaining mute time [s].
    void setAlarms(const std::vector<Alarm>& alarms, double now, double silentFor);
    void setSoundOn(bool on);
    void setSoundTrouble(const QString& why);  ///< reason that no sound plays; empty: none known

    QTableWidget* table() const { return table_; }
    QPushButton* acknowledgeButton() const { return acknowledge_; }
    QPushButton* acknowledgeAllButton() const { return all_; }
    QPushButton* silenceButton(int minutes) const { return minutes == 1 ? one_ : two_; }
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
    void describe(double silentFor);
    QString chosen() const;  ///< id of the selected row; may be empty
    void offer();            ///< enables the actions that are possible now

    QTableWidget* table_ = nullptr;
    QLabel* nothing_ = nullptr;
    QLabel* silence_ = nullptr;
    QPushButton *acknowledge_ = nullptr, *all_ = nullptr, *one_ = nullptr, *two_ = nullptr,
                *try_ = nullptr;
    QLabel* soundTrouble_ = nullptr;
    QCheckBox* sound_ = nullptr;
};

}  // namespace terratact
