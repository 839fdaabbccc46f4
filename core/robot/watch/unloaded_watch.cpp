#include "core/robot/watch/unloaded_watch.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr int kMinLines = 20;
constexpr int kTogether = 4;  // elements

}  // namespace

void UnloadedWatch::reset()
{
    travelled_.reset();
    elements_ = {};
    found_.clear();
}

void UnloadedWatch::suspect(Sensor sensor, double now)
{
    found_.push_back(suspicionFor(kHold, sensor, SensorTrouble::LoadedFree, now,
                                  elements_[indexOf(sensor)].least));
}

void UnloadedWatch::add(Element& element, double force, double way)
{
    const bool isFree = force < kLoad;
    if (element.lines == 0) element.least = force;
    ++element.lines;
    element.free += isFree ? 1 : 0;
    element.way += way;
    if (!isFree) element.least = std::min(element.least, force);
    if (10 * element.free > std::max(element.lines, kMinLines / 2)) element = {};
}

void UnloadedWatch::add(const Measurement& line)
{
    found_.clear();
    const bool isRaised = line.frontLeft >= kRaised && line.frontRight >= kRaised;
    const double way = travelled_ && line.travelled ? std::abs(*line.travelled - *travelled_) : 0.0;
    travelled_ = line.travelled;
    if (line.activity != RobotActivity::Driving || !isRaised || !(way > 0.0)) return;
    const SensorReadings readings = judgedReadings(line);
    std::array<bool, kForceElements> isLoaded{};
    for (std::size_t i = 0; i < kSensors; ++i) {
        if (!readings[i] || kindOf(sensorAt(i)) != SensorKind::Force) continue;
        Element& element = elements_[i];
        add(element, *readings[i], way);
        if (element.lines >= kMinLines && element.way >= kWay)
            isLoaded[elementOf(sensorAt(i))] = true;
    }
    const bool areTogether = std::count(isLoaded.begin(), isLoaded.end(), true) >= kTogether;
    for (std::size_t i = 0; i < kSensors; ++i) {
        const Element& element = elements_[i];
        if (element.lines < kMinLines) continue;
        if (element.way >= kLongWay || (areTogether && element.way >= kWay))
            suspect(sensorAt(i), line.time);
    }
}

}  // namespace terratact
