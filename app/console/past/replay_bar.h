#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace terratact {

class LogReplay;
class KeyTable;

/// The bar below the pages while a log is replayed: position, pause, back, forward, and repeat at the end.
class ReplayBar final : public QWidget {
    Q_OBJECT
public:
    static constexpr double kStep = 10.0;  ///< [s]

    explicit ReplayBar(LogReplay& replay, QWidget* parent);  ///< the replay must outlive the bar

    void addKeys(KeyTable& keys);
    void poll();  ///< call several times a second
    /// Returns true while the log is paused where it was shown last, so that no value becomes stale.
    bool isStill();

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
    bool wasPaused_ = false;
    double pausedAt_ = 0.0;  ///< time of the log [s]
};

}  // namespace terratact
