#pragma once

#include <QObject>
#include <QTimer>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/recording/session_folder.h"
#include "core/base/message.h"

namespace terratact {

/// Maintains the recordings in its own thread, whatever their size. It closes sessions of earlier runs whose program
/// died. Then it deletes closed sessions beyond the user's limits. It can end between two files. GUI thread only.
class SessionRetention final : public QObject {
    Q_OBJECT
public:
    /// earlier: sessions of the folder, found by sessionsIn() before this run's recording began.
    SessionRetention(std::vector<std::string> earlier, std::string folder,
                     const RetentionLimits& limits);
    ~SessionRetention() override;

    void start();  ///< at the first call
    /// Sets the limits. A looser limit applies at once, even to a running deletion. A stricter limit applies after the
    /// grace period, so that a number being typed, or a mistake, deletes nothing.
    void setLimits(const RetentionLimits& limits);
    void setGrace(int milliseconds) { grace_.setInterval(milliseconds); }
    static constexpr int kGrace = 10'000;  ///< [ms]

    /// Returns the news since the last call, one sentence each.
    std::vector<Message> consumeNews();

signals:
    void news();  ///< consumeNews() has news

private:
    void run(const std::stop_token& stop);
    void apply(const RetentionLimits& limits);
    bool inForce(const RetentionLimits& limits);
    void addNews(const std::vector<Message>& sentences);

    std::vector<std::string> earlier_;
    std::string folder_;
    RetentionLimits wanted_;
    QTimer grace_;
    std::mutex mutex_;  // guards the members below
    RetentionLimits limits_;
    bool due_ = true;  ///< the limits are not applied yet
    std::condition_variable_any limitsSet_;
    std::vector<Message> news_;
    std::jthread thread_;  // last member: it ends before all others are destroyed
};

}  // namespace terratact
