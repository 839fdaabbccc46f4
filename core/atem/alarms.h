#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace terratact {

/// Of the alarm that a sensor is suspected; a session that holds it withholds the verdict (core/log/review_moment.h).
inline constexpr std::string_view kSensorAlarm = "sensor-fault";

/// How much an alarm matters.
enum class Severity : std::uint8_t {
    Caution,   ///< shown
    Critical,  ///< sounds, too, until somebody has seen it
};

/// Where an alarm is between its cause and being forgotten.  In the order of urgency.
///
///           raise ──▶ Unacknowledged ──clear──▶ Returned ──acknowledge──▶ (gone)
///                      │          ▲                 │
///                 acknowledge     └──────raise──────┘
///                      ▼
///                 Acknowledged ──clear──▶ (gone)
enum class AlarmState : std::uint8_t {
    Unacknowledged,  ///< the cause stands, nobody has seen it
    Returned,        ///< the cause is gone, nobody has seen it: it waits to be seen
    Acknowledged,    ///< the cause stands, somebody has seen it
};
inline constexpr int kAlarmStates = 3;
std::string describe(AlarmState state);
std::string describe(Severity severity);

struct Alarm {
    std::string id;    ///< of the cause: one alarm each
    std::string text;  ///< for the operator, as it was last raised
    Severity severity = Severity::Caution;
    AlarmState state = AlarmState::Unacknowledged;
    double since = 0.0;        ///< [s] the cause stands, or stood, since
    double returned = 0.0;     ///< [s] of Returned: when it went
    std::uint64_t raised = 1;  ///< times since it was last gone
    bool operator==(const Alarm&) const = default;
};

/// What is wrong or was and has not been seen, latched.  No clock: `now` is any monotonic clock [s]; NaN and
/// infinite times throw std::invalid_argument.
class AlarmList {
public:
    static constexpr std::size_t kMax = 64;  ///< beyond it the least urgent is forgotten
    static constexpr double kSoundPeriod =
        10.0;                                 ///< [s] between two sounds for what is known already
    static constexpr double kSoundGap = 2.0;  ///< [s] alarms that come together sound once

    /// The cause stands.  While it does, only text and severity change; a severity that rises, or a cause
    /// that comes back, has to be acknowledged anew.
    void raise(const std::string& id, const std::string& text, Severity severity, double now);

    /// The cause is gone; nothing happens where there is no such alarm.
    void clear(const std::string& id, double now);

    void acknowledge(const std::string& id);
    void acknowledgeAll();

    /// No sound until `until` [s], except for an alarm that is new by then, which ends the silence.
    void silence(double until);
    /// How long it is still silent [s]; 0: it is not.
    double silentFor(double now) const;

    /// Whether it has to sound now: at once for a critical alarm that is new, every kSoundPeriod while one is
    /// unacknowledged; never for one that returns or is acknowledged.  An alarm whose cause comes and goes is
    /// new once in kSoundPeriod.  The sound counts as made.
    bool takeSound(double now);

    /// The most urgent first, of these the critical ones, of these the newest.
    const std::vector<Alarm>& alarms() const { return alarms_; }
    std::size_t count(AlarmState state) const;

private:
    struct Heard {
        std::string id;
        double at;  ///< [s] when it last was new
    };
    Alarm* find(const std::string& id);
    void announce(const std::string& id, double now);
    void sort();

    std::vector<Alarm> alarms_;
    std::vector<Heard> heard_;  ///< within the last kSoundPeriod, gone alarms among them
    bool isNew_ = false;        ///< a critical alarm has not sounded yet
    double silentUntil_ = 0.0;
    std::optional<double> sounded_;
};

}  // namespace terratact
