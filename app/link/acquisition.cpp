#include "app/link/acquisition.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace terratact {

using namespace std::chrono_literals;

namespace {

double silenceBetween(const Received& before, const Received& now)
{
    return std::max(secondsOf(now.arrived) - secondsOf(before.arrived),
                    now.arrivedSleepless - before.arrivedSleepless);
}

}  // namespace

Received received(const std::optional<Received>& before, Sample sample, const Arrival& arrived)
{
    Received now{.sample = sample,
                 .arrived = arrived.steady,
                 .arrivedSleepless = arrived.sleepless,
                 .count = 1};
    if (before) {
        now.count = before->count + 1;
        const bool isBroken = silenceBetween(*before, now) > kMaxSilence;
        now.unbrokenFrom = isBroken ? now.count : before->unbrokenFrom;
        now.press = before->press;
    }
    const RobotActivity activity = now.sample.measurement.activity;
    const bool stands =
        activity == RobotActivity::Pressed || (activity == RobotActivity::Probing && now.press);
    if (!stands)
        now.press.reset();
    else if (!now.press)
        now.press = Press{now.sample, now.count};
    return now;
}

Acquisition::Acquisition(MeasurementSource& source, std::function<void()> received,
                         const std::optional<RobotModel>& robot)
    : source_(source), received_(std::move(received)),
      sensors_(robot ? std::optional<SensorWatch>(*robot) : std::nullopt),
      thread_([this](const std::stop_token& stop) { read(stop); })
{
}

void Acquisition::receive(const Sample& sample)
{
    const SteadyTime now = std::chrono::steady_clock::now();
    if (sensors_) sensors_->add(sample.measurement);
    {
        const std::scoped_lock lock(mutex_);
        latest_ = received(latest_, sample, {now, sleeplessNow()});
        if (sensors_) latest_->suspicions = sensors_->standing();
        arrivals_.push_back(now);
        while (now - arrivals_.front() > 1s) arrivals_.pop_front();
        trouble_ = {};
        if (listener_) listener_(*latest_);
    }
    if (received_) received_();
}

void Acquisition::listen(const Listener& listener)
{
    const std::scoped_lock lock(mutex_);
    listener_ = listener;
}

void Acquisition::read(const std::stop_token& stop)
{
    while (!stop.stop_requested()) {
        Message trouble;
        try {
            auto next = source_.next(50ms);
            if (next && !*next) continue;
            if (next) {
                receive(**next);
                continue;
            }
            trouble = next.error().message;
        } catch (const std::exception& error) {
            trouble = messageOf(error);
        }
        {
            const std::scoped_lock lock(mutex_);
            trouble_ = trouble;
        }
        std::this_thread::sleep_for(50ms);  // a source that fails at once must not busy-loop
    }
}

std::optional<Received> Acquisition::latest() const
{
    const std::scoped_lock lock(mutex_);
    return latest_;
}

double Acquisition::rate() const
{
    const SteadyTime now = std::chrono::steady_clock::now();
    const std::scoped_lock lock(mutex_);
    return static_cast<double>(
        std::count_if(arrivals_.begin(), arrivals_.end(),
                      [now](SteadyTime arrived) { return now - arrived <= 1s; }));
}

Message Acquisition::trouble() const
{
    const std::scoped_lock lock(mutex_);
    return trouble_;
}

}  // namespace terratact
