#include "core/log/session_survey.h"
#include "core/limits.h"

#include <algorithm>

#include "core/log/review_moment.h"

namespace terratact {

SessionSurvey::SessionSurvey(const RobotModel& robot, double threshold)
    : listener_(robot), threshold_(threshold)
{
}

bool SessionSurvey::takeNext(SessionReader& reader)
{
    if (next_ >= reader.batches().size()) return false;
    for (const FrameRow& row : reader.frames(next_))
        if (const auto measurement = listener_.take(row.frame, secondsOf(row.time)))
            take(*measurement, row.time);
    ++next_;
    return true;
}

void SessionSurvey::take(const Measurement& measurement, SessionTime time)
{
    if (heard_ && secondsOf(time - *heard_) > kLinkLostAfter) {
        silences_.push_back({*heard_, time});
        touches_ = false;
    }
    heard_ = time;
    const bool touches = std::any_of(measurement.force.begin(), measurement.force.end(),
                                     [this](double force) { return force > threshold_; });
    if (touches && !touches_) contacts_.push_back({time, time});
    if (touches) contacts_.back().last = time;
    touches_ = touches;
}

}  // namespace terratact
