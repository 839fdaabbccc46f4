#include "app/shell/alarm_sound.h"

#include <QApplication>
#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <numbers>
#include <optional>
#include <thread>
#include <utility>

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

    void tick(double pitch, double level) override
    {
        const std::lock_guard lock(mutex_);
        if (wanted_ || sounds_) return;
        tick_ = Tick{pitch, level};
        changed_.notify_one();
    }

private:
    struct Tick {
        double pitch, level;
    };

    void run(const std::stop_token& stop)
    {
        const std::vector<std::int16_t> samples = alarmSamples(kRate);
        while (true) {
            std::optional<Tick> tick;
            {
                std::unique_lock lock(mutex_);
                sounds_ = false;
                if (!changed_.wait(lock, stop, [this] { return wanted_ || tick_; })) return;
                sounds_ = std::exchange(wanted_, false);
                tick = std::exchange(tick_, std::nullopt);
                if (sounds_) tick.reset();  // the alarm has priority
            }
            if (tick)
                (void)playAudio("default", contactSamples(kRate, tick->pitch, tick->level), kRate);
            else
                playAlarm(samples);
        }
    }

    void playAlarm(const std::vector<std::int16_t>& samples)
    {
        const Status played = playAudio("default", samples, kRate);
        if (!played) QMetaObject::invokeMethod(qApp, [] { QApplication::beep(); });
        const std::lock_guard lock(mutex_);
        trouble_ = played ? QString() : translated(played.error().message);
    }

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    bool wanted_ = false;       ///< the alarm is due
    bool sounds_ = false;       ///< the alarm sounds now
    std::optional<Tick> tick_;  ///< the tick that is due
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

std::vector<std::int16_t> contactSamples(unsigned rate, double pitch, double level)
{
    constexpr double kSeconds = 0.06, kDecay = 0.02;  // [s]
    constexpr double kOctave = 0.4;                   // share of the octave above
    const double loud = 0.25 * std::numeric_limits<std::int16_t>::max()
                      * std::clamp(level, 0.0, 1.0) / (1.0 + kOctave);
    const auto count = static_cast<int>(kSeconds * rate);
    std::vector<std::int16_t> samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double t = i / static_cast<double>(rate);
        const double fade = std::clamp(std::min(t, kSeconds - t) / kFade, 0.0, 1.0);
        const double turn = 2.0 * std::numbers::pi * pitch * t;
        const double wave = std::sin(turn) + kOctave * std::sin(2.0 * turn);
        samples.push_back(static_cast<std::int16_t>(loud * fade * std::exp(-t / kDecay) * wave));
    }
    return samples;
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
