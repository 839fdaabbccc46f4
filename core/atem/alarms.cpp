#include "core/atem/alarms.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace terratact {
namespace {

void requireTime(double now)
{
    if (!std::isfinite(now)) throw std::invalid_argument("AlarmList: the time must be finite");
}

}  // namespace

Alarm* AlarmList::find(const std::string& id)
{
    const auto found = std::find_if(alarms_.begin(), alarms_.end(),
                                    [&](const Alarm& alarm) { return alarm.id == id; });
    return found == alarms_.end() ? nullptr : &*found;
}

void AlarmList::sort()
{
    std::stable_sort(alarms_.begin(), alarms_.end(), [](const Alarm& a, const Alarm& b) {
        return std::tuple(a.state, b.severity, b.since) < std::tuple(b.state, a.severity, a.since);
    });
    if (alarms_.size() > kMax) alarms_.resize(kMax);
}

void AlarmList::announce(const std::string& id, double now)
{
    std::erase_if(sounds_, [now](const Sound& sound) { return now - sound.at >= kSoundPeriod; });
    const bool known = std::any_of(sounds_.begin(), sounds_.end(),
                                   [&](const Sound& sound) { return sound.id == id; });
    if (known || sounds_.size() >= kMax) return;
    sounds_.push_back({id, now});
    isNew_ = true;
    silentUntil_ = now;
}

void AlarmList::raise(const std::string& id, const Message& text, Severity severity, double now)
{
    requireTime(now);
    Alarm* alarm = find(id);
    const bool isAnew = !alarm || alarm->state == AlarmState::Returned;
    const bool isWorse = alarm && severity > alarm->severity;
    if (!alarm) {
        alarm = &alarms_.emplace_back(
            Alarm{.id = id, .text = text, .severity = severity, .since = now});
    } else if (isAnew || isWorse) {
        alarm->since = now;
        if (isAnew) ++alarm->raised;
    }
    alarm->text = text;
    alarm->severity = severity;
    if (!isAnew && !isWorse) return;
    alarm->state = AlarmState::Unacknowledged;
    sort();
    if (severity == Severity::Critical) announce(id, now);
}

void AlarmList::clear(const std::string& id, double now)
{
    requireTime(now);
    Alarm* alarm = find(id);
    if (!alarm || alarm->state == AlarmState::Returned) return;
    if (alarm->state == AlarmState::Acknowledged) {
        alarms_.erase(alarms_.begin() + (alarm - alarms_.data()));
        return;
    }
    alarm->state = AlarmState::Returned;
    alarm->returned = now;
    sort();
}

void AlarmList::acknowledge(const std::string& id)
{
    Alarm* alarm = find(id);
    if (!alarm) return;
    if (alarm->state == AlarmState::Returned)
        alarms_.erase(alarms_.begin() + (alarm - alarms_.data()));
    else
        alarm->state = AlarmState::Acknowledged;
    sort();
}

void AlarmList::acknowledgeAll()
{
    std::erase_if(alarms_, [](const Alarm& a) { return a.state == AlarmState::Returned; });
    for (Alarm& alarm : alarms_) alarm.state = AlarmState::Acknowledged;
    sort();
}

void AlarmList::silence(double until)
{
    requireTime(until);
    silentUntil_ = until;
}

double AlarmList::silentFor(double now) const
{
    requireTime(now);
    return std::max(0.0, silentUntil_ - now);
}

bool AlarmList::consumeSound(double now)
{
    requireTime(now);
    const bool stands = std::any_of(alarms_.begin(), alarms_.end(), [](const Alarm& a) {
        return a.state == AlarmState::Unacknowledged && a.severity == Severity::Critical;
    });
    if (!stands) isNew_ = false;
    if (!stands || silentFor(now) > 0.0) return false;
    const double pause = isNew_ ? kSoundGap : kSoundPeriod;
    isNew_ = false;
    if (sounded_ && now - *sounded_ < pause) return false;
    sounded_ = now;
    return true;
}

std::size_t AlarmList::count(AlarmState state) const
{
    return static_cast<std::size_t>(std::count_if(
        alarms_.begin(), alarms_.end(), [state](const Alarm& a) { return a.state == state; }));
}

}  // namespace terratact
