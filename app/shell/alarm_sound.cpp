#include "app/shell/alarm_sound.h"

#include <QApplication>
#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <numbers>
#include <thread>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "drivers/audio_output.h"

namespace terratact {
namespace {

constexpr unsigned kRate = 48'000;                            // [Hz]
constexpr double kTone = 0.16, kPause = 0.06, kFade = 0.005;  // [s]

class DesktopBeep final : public AlarmSound {
public:
    void sound() override { QApplication::beep(); }
};

class AlarmTone final : public AlarmSound {
public:
    void sound() override
    {
        const std::lock_guard lock(mutex_);
        wanted_ = true;
        changed_.notify_one();
    }
    QString trouble() const override
    {
        const std::lock_guard lock(mutex_);
        return trouble_;
    }

private:
    void run(const std::stop_token& stop)
    {
        const std::vector<std::int16_t> samples = alarmSamples(kRate);
        for (;;) {
            {
                std::unique_lock lock(mutex_);
                if (!changed_.wait(lock, stop, [this] { return wanted_; })) return;
                wanted_ = false;
            }
            const Status played = playAudio("default", samples, kRate);
            if (!played) QMetaObject::invokeMethod(qApp, [] { QApplication::beep(); });
            const std::lock_guard lock(mutex_);
            trouble_ = played ? QString() : translated(played.error().message);
        }
    }

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    bool wanted_ = false;
    QString trouble_;
    std::jthread thread_{[this](const std::stop_token& stop) {
        run(stop);
    }};  // last member: the thread starts after all others exist
};

}  // namespace

std::unique_ptr<AlarmSound> desktopBeep()
{
    return std::make_unique<DesktopBeep>();
}

std::unique_ptr<AlarmSound> alarmTone()
{
    return std::make_unique<AlarmTone>();
}

std::vector<std::int16_t> alarmSamples(unsigned rate)
{
    constexpr double kLoud = 0.6 * std::numeric_limits<std::int16_t>::max();
    std::vector<std::int16_t> samples;
    const auto count = [rate](double seconds) { return static_cast<int>(seconds * rate); };
    for (const double pitch : {880.0, 1320.0}) {  // [Hz]
        for (int i = 0; i < count(kTone); ++i) {
            const double t = i / static_cast<double>(rate);
            const double fade = std::clamp(std::min(t, kTone - t) / kFade, 0.0, 1.0);
            samples.push_back(static_cast<std::int16_t>(
                kLoud * fade * std::sin(2.0 * std::numbers::pi * pitch * t)));
        }
        samples.insert(samples.end(), static_cast<std::size_t>(count(kPause)), 0);
    }
    return samples;
}

}  // namespace terratact
