#include "app/session_housekeeping.h"

#include <utility>

namespace terratact {

SessionHousekeeping::SessionHousekeeping(std::vector<std::string> paths,
                                         const SessionRetention& limits)
    : paths_(std::move(paths)), wanted_(limits), limits_(limits)
{
    grace_.setSingleShot(true);
    grace_.setInterval(kGrace);
    connect(&grace_, &QTimer::timeout, this, [this] {
        {
            const std::scoped_lock lock(mutex_);
            limits_ = wanted_;
            due_ = true;
        }
        limitsSet_.notify_one();
    });
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

void SessionHousekeeping::setLimits(const SessionRetention& limits)
{
    if (limits == wanted_) return;
    wanted_ = limits;
    grace_.start();
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
    for (;;) {
        SessionRetention limits;
        {
            std::unique_lock lock(mutex_);
            (void)limitsSet_.wait(lock, stop, [this] { return due_; });
            if (stop.stop_requested()) return;
            due_ = false;
            limits = limits_;
        }
        tell(applyRetention(paths_, limits));
    }
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
