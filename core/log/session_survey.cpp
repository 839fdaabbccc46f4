#include "core/log/session_survey.h"
#include "core/limits.h"

#include <algorithm>

#include "core/log/review_moment.h"

namespace terratact {

SessionSurvey::SessionSurvey(const RobotModel& robot, double threshold)
    : listener_(robot), threshold_(threshold)
{
}

bool SessionSurvey::addNext(SessionReader& reader)
{
    if (next_ >= reader.batches().size()) return false;
    for (const FrameRow& row : reader.frames(next_))
        if (const auto measurement = listener_.receive(row.frame, secondsOf(row.time)))
            add(*measurement, row.time);
    ++next_;
    return true;
}

void SessionSurvey::add(const Measurement& measurement, SessionTime time)
{
    if (newestTelemetry_ && secondsOf(time - *newestTelemetry_) > kLinkLostAfter) {
        silences_.push_back({*newestTelemetry_, time});
        touches_ = false;
    }
    newestTelemetry_ = time;
    const bool touches = std::any_of(measurement.force.begin(), measurement.force.end(),
                                     [this](double force) { return force > threshold_; });
    if (touches && !touches_) contacts_.push_back({time, time});
    if (touches) contacts_.back().last = time;
    touches_ = touches;
}

}  // namespace terratact
