#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/recording/session_recorder.h"

namespace terratact {

/// Looks after the recordings in a thread of its own, however large they are: closes those of earlier runs whose program
/// died, then deletes what is beyond the user's limits, never what is not closed.  Between two files it can be ended.
/// GUI thread only.
class SessionRetention final : public QObject {
    Q_OBJECT
public:
    /// earlier: the folder's sessions as sessionsIn() found them before this run's own recording began.
    SessionRetention(std::vector<std::string> earlier, std::string folder,
                     const RetentionLimits& limits);
    ~SessionRetention() override;

    void start();  ///< at the first call
    /// Other limits.  A looser one is in force at once, also for a deletion that is under way.  A stricter one deletes
    /// once it has stood for the grace, so that a number that is being typed, or was mistaken, deletes nothing.
    void setLimits(const RetentionLimits& limits);
    void setGrace(int milliseconds) { grace_.setInterval(milliseconds); }
    static constexpr int kGrace = 10'000;  ///< [ms]

    /// What there was to tell since the last call, a sentence each.
    QStringList takeNews();

signals:
    void news();  ///< to takeNews()

private:
    void run(const std::stop_token& stop);
    void apply(const RetentionLimits& limits);
    bool inForce(const RetentionLimits& limits);
    void tell(const std::vector<std::string>& sentences);

    std::vector<std::string> earlier_;
    std::string folder_;
    RetentionLimits wanted_;
    QTimer grace_;
    std::mutex mutex_;  // guards what follows
    RetentionLimits limits_;
    bool due_ = true;  ///< they have not been applied yet
    std::condition_variable_any limitsSet_;
    std::vector<std::string> news_;
    std::jthread thread_;  // last: it ends before all else goes
};

}  // namespace terratact
