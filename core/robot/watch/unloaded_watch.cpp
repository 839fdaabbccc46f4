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

void UnloadedWatch::suspect(std::size_t element, double now)
{
    found_.push_back({.sensor = sensorAt(indexOf(Sensor::Force1) + element),
                      .trouble = SensorTrouble::LoadedFree,
                      .since = now,
                      .until = now + kHold,
                      .amount = elements_[element].least,
                      .way = 0.0});
}

void UnloadedWatch::take(const Measurement& line)
{
    found_.clear();
    const bool isRaised = line.frontLeft >= kRaised && line.frontRight >= kRaised;
    const double way = travelled_ && line.travelled ? std::abs(*line.travelled - *travelled_) : 0.0;
    travelled_ = line.travelled;
    if (line.activity != RobotActivity::Driving || !isRaised || !(way > 0.0)) return;
    int together = 0;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        Element& element = elements_[e];
        const double force = line.force[e];
        const bool isFree = force < kLoad;
        if (element.lines == 0) element.least = force;
        ++element.lines;
        element.free += isFree ? 1 : 0;
        element.way += way;
        if (!isFree) element.least = std::min(element.least, force);
        if (10 * element.free > std::max(element.lines, kMinLines / 2)) element = {};
        if (element.lines >= kMinLines && element.way >= kWay) ++together;
    }
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const Element& element = elements_[e];
        const bool isLong = element.way >= kLongWay;
        if (element.lines >= kMinLines
            && (isLong || (together >= kTogether && element.way >= kWay)))
            suspect(e, line.time);
    }
}

}  // namespace terratact
