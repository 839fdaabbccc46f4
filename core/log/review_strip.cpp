#include "core/log/review_strip.h"

#include <algorithm>
#include <utility>

namespace terratact {
namespace {

constexpr std::size_t kCopies = 24;  // strips that are kept
constexpr double kApart = 10.0;      // [s] least time between two of them

/// Returns the time at which the strip of a moment begins.
SessionTime beginFor(SessionTime time)
{
    const SessionTime step = sessionTimeOf(ReviewStrip::kStep);
    const SessionTime from = (time / step) * step - sessionTimeOf(ReviewStrip::kShortest);
    return std::max<SessionTime>(from, -1);
}

}  // namespace

ReviewStrip::ReviewStrip(SessionReader& reader, RobotModel robot)
    : reader_(reader), robot_(std::move(robot))
{
}

ReviewStrip::ViewState ReviewStrip::at(const ReviewMoment& moment)
{
    const SessionTime from = beginFor(moment.time);
    if (followed_.empty() || from != from_) begin(from);
    while (!followed_.empty() && followed_.back().time() > moment.time) followed_.pop_back();
    if (followed_.empty()) begin(from);
    goTo(moment.time);
    const Strip& strip = followed_.back().strip();
    const bool isWhole = from_ < 0;
    return {strip.seen(), strip.earlier(), strip.whyNothing(),
            isWhole ? std::optional(strip.ledger()) : std::nullopt};
}

void ReviewStrip::begin(SessionTime from)
{
    from_ = from;
    followed_.clear();
    followed_.emplace_back(reader_, robot_, from);
}

void ReviewStrip::goTo(SessionTime until)
{
    const SessionTime apart = sessionTimeOf(kApart);
    while (followed_.back().time() < until) {
        const auto before = followed_.rbegin() + 1;
        if (before == followed_.rend() || followed_.back().time() - before->time() >= apart)
            followed_.push_back(followed_.back());
        if (followed_.size() > kCopies)  // every other one of the older ones goes
            for (std::size_t k = 1; k + 2 < followed_.size(); ++k)
                followed_.erase(followed_.begin() + static_cast<std::ptrdiff_t>(k));
        followed_.back().goTo(std::min(until, followed_.back().time() + apart));
    }
}

}  // namespace terratact
