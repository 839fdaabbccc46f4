#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace terratact {

class LogReplay;
class KeyTable;

/// Below the pages of a console that replays a log: how far it is, to pause, to go back and on, to begin again at its end.
class ReplayBar final : public QWidget {
    Q_OBJECT
public:
    static constexpr double kStep = 10.0;  ///< [s]

    explicit ReplayBar(LogReplay& replay, QWidget* parent);  ///< which must outlive it

    void addKeys(KeyTable& keys);
    void poll();  ///< several times a second

    QPushButton* pauseButton() const { return pause_; }
    QPushButton* repeatButton() const { return repeat_; }
    QPushButton* backButton() const { return back_; }
    QPushButton* onButton() const { return on_; }

private:
    void step(double seconds);

    LogReplay& replay_;
    QPushButton* pause_ = nullptr;
    QPushButton* back_ = nullptr;
    QPushButton* on_ = nullptr;
    QPushButton* repeat_ = nullptr;
    QLabel* at_ = nullptr;
};

}  // namespace terratact
