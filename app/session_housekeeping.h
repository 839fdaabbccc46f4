#pragma once

#include <QObject>
#include <QStringList>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/session_recorder.h"

namespace terratact {

/// Looks after the recordings of earlier runs in a thread of its own, however large they are: closes those whose program
/// died, then deletes what is beyond the user's limits.  Between two files it can be ended.
class SessionHousekeeping final : public QObject {
    Q_OBJECT
public:
    /// paths: as sessionsIn() found them before this run's own recording began.
    SessionHousekeeping(std::vector<std::string> paths, const SessionRetention& limits);
    ~SessionHousekeeping() override;

    void start();  ///< at the first call

    /// What there was to tell since the last call, a sentence each.
    QStringList takeNews();

signals:
    void news();  ///< to takeNews()

private:
    void run(const std::stop_token& stop);
    void tell(const std::vector<std::string>& sentences);

    std::vector<std::string> paths_;
    SessionRetention limits_;
    std::mutex mutex_;  // guards what follows
    QStringList news_;
    std::jthread thread_;  // last: it ends before all else goes
};

}  // namespace terratact
