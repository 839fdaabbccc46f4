#include "app/console/past/session_retention.h"

#include <algorithm>
#include <utility>

namespace terratact {
namespace {

double looser(double a, double b)
{
    return a <= 0.0 || b <= 0.0 ? 0.0 : std::max(a, b);
}

}  // namespace

SessionRetention::SessionRetention(std::vector<std::string> earlier, std::string folder,
                                   const RetentionLimits& limits)
    : earlier_(std::move(earlier)), folder_(std::move(folder)), wanted_(limits), limits_(limits)
{
    grace_.setSingleShot(true);
    grace_.setInterval(kGrace);
    connect(&grace_, &QTimer::timeout, this, [this] { apply(wanted_); });
}

SessionRetention::~SessionRetention()
{
    thread_ = {};  // requests the end and waits
}

void SessionRetention::start()
{
    if (thread_.joinable()) return;
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void SessionRetention::setLimits(const RetentionLimits& limits)
{
    if (limits == wanted_) return;
    wanted_ = limits;
    RetentionLimits now;
    {
        const std::scoped_lock lock(mutex_);
        now = {.days = looser(limits_.days, wanted_.days),
               .gigabytes = looser(limits_.gigabytes, wanted_.gigabytes),
               .confirmed = limits_.confirmed && wanted_.confirmed};
    }
    apply(now);
    if (now == wanted_)
        grace_.stop();
    else
        grace_.start();
}

void SessionRetention::apply(const RetentionLimits& limits)
{
    {
        const std::scoped_lock lock(mutex_);
        if (limits_ == limits) return;
        limits_ = limits;
        due_ = true;
    }
    limitsSet_.notify_one();
}

bool SessionRetention::inForce(const RetentionLimits& limits)
{
    const std::scoped_lock lock(mutex_);
    return limits_ == limits;
}

std::vector<Message> SessionRetention::consumeNews()
{
    const std::scoped_lock lock(mutex_);
    return std::exchange(news_, {});
}

void SessionRetention::run(const std::stop_token& stop)
{
    for (const std::string& path : earlier_) {
        if (stop.stop_requested()) return;
        addNews(recoverDeadSessions({path}));
    }
    for (;;) {
        RetentionLimits limits;
        {
            std::unique_lock lock(mutex_);
            (void)limitsSet_.wait(lock, stop, [this] { return due_; });
            if (stop.stop_requested()) return;
            due_ = false;
            limits = limits_;
        }
        addNews(applyRetention(sessionsIn(folder_), limits, wallNow(),
                               [&] { return !stop.stop_requested() && inForce(limits); }));
    }
}

void SessionRetention::addNews(const std::vector<Message>& sentences)
{
    if (sentences.empty()) return;
    {
        const std::scoped_lock lock(mutex_);
        news_.insert(news_.end(), sentences.begin(), sentences.end());
    }
    emit news();
}

}  // namespace terratact
