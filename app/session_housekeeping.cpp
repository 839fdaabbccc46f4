#include "app/session_housekeeping.h"

#include <utility>

namespace terratact {

SessionHousekeeping::SessionHousekeeping(std::vector<std::string> paths,
                                         const SessionRetention& limits)
    : paths_(std::move(paths)), limits_(limits)
{
}

SessionHousekeeping::~SessionHousekeeping()
{
    thread_ = {};  // asks it to end, and waits
}

void SessionHousekeeping::start()
{
    if (thread_.joinable()) return;
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

QStringList SessionHousekeeping::takeNews()
{
    const std::scoped_lock lock(mutex_);
    return std::exchange(news_, {});
}

void SessionHousekeeping::run(const std::stop_token& stop)
{
    for (const std::string& path : paths_) {
        if (stop.stop_requested()) return;
        tell(recoverDeadSessions({path}));
    }
    if (!stop.stop_requested()) tell(applyRetention(paths_, limits_));
}

void SessionHousekeeping::tell(const std::vector<std::string>& sentences)
{
    if (sentences.empty()) return;
    {
        const std::scoped_lock lock(mutex_);
        for (const std::string& sentence : sentences) news_ << QString::fromStdString(sentence);
    }
    emit news();
}

}  // namespace terratact
