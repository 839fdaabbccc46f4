#include "core/robot/watch/sensor_watch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace terratact {
namespace {

auto keyOf(const SensorSuspicion& s)
{
    return std::tuple(s.sensor, s.trouble);
}

}  // namespace

SensorWatch::SensorWatch(const RobotModel& robot)
    : spikes_(robot), presses_(robot), pitchSign_(robot), ground_(robot), return_(robot)
{
}

void SensorWatch::reset()
{
    stuck_ = {};
    spikes_.reset();
    presses_.reset();
    pitchSign_.reset();
    unloaded_.reset();
    sides_.reset();
    ground_.reset();
    return_.reset();
    last_.reset();
}

void SensorWatch::add(const Measurement& line)
{
    if (!std::isfinite(line.time))
        throw std::invalid_argument("SensorWatch: the time must be finite");
    if (last_ && line.time < *last_) standing_.clear();
    if (last_ && (line.time < *last_ || line.time - *last_ > kMaxSilence)) reset();
    last_ = line.time;
    stuck_.add(line);
    spikes_.add(line);
    presses_.add(line);
    pitchSign_.add(line);
    unloaded_.add(line);
    sides_.add(line);
    ground_.add(line);
    return_.add(line);
    for (const auto* found :
         {&stuck_.found(), &spikes_.found(), &presses_.found(), &pitchSign_.found(),
          &unloaded_.found(), &sides_.found(), &ground_.found(), &return_.found()})
        for (const SensorSuspicion& suspicion : *found) note(suspicion);
    forgetCleared();
    forgetOld(line.time);
    preferSides();
}

/// Drops suspicions of means for a fault that one side has: it shows in the mean, too.
void SensorWatch::preferSides()
{
    std::erase_if(standing_, [this](const SensorSuspicion& mean) {
        return isMeanForce(mean.sensor)
            && std::any_of(standing_.begin(), standing_.end(), [&mean](const SensorSuspicion& s) {
                   return isSideForce(s.sensor) && s.trouble == mean.trouble;
               });
    });
}

void SensorWatch::forgetCleared()
{
    const auto isOfPitchSign = [](const SensorSuspicion& s) {
        return s.sensor == Sensor::Pitch && s.trouble == SensorTrouble::Flipped;
    };
    if (pitchSign_.isCleared()) std::erase_if(standing_, isOfPitchSign);
    for (const Sensor sensor : presses_.cleared())
        std::erase_if(standing_, [&](const SensorSuspicion& s) {
            return s.sensor == sensor && PressWatch::judges(s.trouble) && !isOfPitchSign(s);
        });
    std::erase_if(standing_, [this](const SensorSuspicion& s) {
        if (isSideForce(s.sensor)) return sides_.isCleared(s);
        return ground_.isCleared(s)
            || (s.trouble == SensorTrouble::BothWays && return_.isCleared());
    });
}

void SensorWatch::note(const SensorSuspicion& found)
{
    const auto place =
        std::lower_bound(standing_.begin(), standing_.end(), found,
                         [](const auto& a, const auto& b) { return keyOf(a) < keyOf(b); });
    if (place == standing_.end() || keyOf(*place) != keyOf(found)) {
        standing_.insert(place, found);
        return;
    }
    const double since = place->since;
    *place = found;
    place->since = since;
}

void SensorWatch::forgetOld(double now)
{
    std::erase_if(standing_, [now](const SensorSuspicion& s) { return s.until < now; });
}

}  // namespace terratact
