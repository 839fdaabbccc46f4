#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace terratact {

/// Identifier of the sensor alarm. A session that holds it withholds the verdict
/// (core/log/review_moment.h).
inline constexpr std::string_view kSensorAlarm = "sensor-fault";

/// Severity of an alarm.
enum class Severity : std::uint8_t {
    Caution,   ///< shown on the screen
    Critical,  ///< shown, and sounds until it is acknowledged
};

/// State of an alarm between its cause and its removal, in the order of urgency.
///
///           raise ──▶ Unacknowledged ──clear──▶ Returned ──acknowledge──▶ (gone)
///                      │          ▲                 │
///                 acknowledge     └──────raise──────┘
///                      ▼
///                 Acknowledged ──clear──▶ (gone)
enum class AlarmState : std::uint8_t {
    Unacknowledged,  ///< the cause persists, nobody has acknowledged it
    Returned,        ///< the cause is gone, nobody has acknowledged it
    Acknowledged,    ///< the cause persists, the operator has acknowledged it
};

struct Alarm {
    std::string id;  ///< identifies the cause: one alarm per cause
    Message text;    ///< text for the operator, as last raised
    Severity severity = Severity::Caution;
    AlarmState state = AlarmState::Unacknowledged;
    double since = 0.0;        ///< time at which the cause began, or last became worse [s]
    double returned = 0.0;     ///< time at which the cause ended [s], for Returned
    std::uint64_t raised = 1;  ///< times it was raised since it was last gone
    bool operator==(const Alarm&) const = default;
};

/// Latched alarms: present causes, and past causes that nobody has acknowledged. It has no clock:
/// `now` is any monotonic clock [s]. Throws std::invalid_argument for NaN and infinite times.
class AlarmList {
public:
    /// Largest number of alarms; the least urgent is dropped beyond it.
    static constexpr std::size_t kMax = 64;
    static constexpr double kSoundPeriod = 10.0;  ///< [s] between two sounds for the same alarms
    static constexpr double kSoundGap = 2.0;      ///< [s] alarms within this time sound once

    /// Raises an alarm. While the cause persists, only text and severity change. A higher severity,
    /// or a cause that comes back, must be acknowledged again, and its time counts from then.
    void raise(const std::string& id, const Message& text, Severity severity, double now);

    /// Ends the cause of an alarm. Does nothing if there is no such alarm.
    void clear(const std::string& id, double now);

    void acknowledge(const std::string& id);
    void acknowledgeAll();

    /// Mutes the sound until `until` [s]. A new alarm ends the mute.
    void silence(double until);
    /// Returns how long the sound is still muted [s]; 0: it is not muted.
    double silentFor(double now) const;

    /// Returns true if the alarm must sound now, and counts it as sounded. A new critical alarm
    /// sounds at once, an unacknowledged one every kSoundPeriod. A returned or acknowledged alarm
    /// never sounds. An alarm whose cause keeps returning is new once in kSoundPeriod.
    bool consumeSound(double now);

    /// Returns the alarms: the most urgent first, then the critical ones, then the newest.
    const std::vector<Alarm>& alarms() const { return alarms_; }
    std::size_t count(AlarmState state) const;

private:
    struct Sound {
        std::string id;
        double at;  ///< time at which it was last new [s]
    };
    Alarm* find(const std::string& id);
    void announce(const std::string& id, double now);
    void sort();

    std::vector<Alarm> alarms_;
    std::vector<Sound> sounds_;  ///< alarms of the last kSoundPeriod, also those that are gone
    bool isNew_ = false;         ///< a critical alarm has not sounded yet
    double silentUntil_ = 0.0;
    std::optional<double> sounded_;
};

}  // namespace terratact
