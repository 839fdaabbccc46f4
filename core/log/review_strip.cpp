#include "core/log/review_strip.h"

#include <algorithm>
#include <utility>

namespace terratact {
namespace {

constexpr std::size_t kCopies = 24;  // strips that are kept
constexpr double kApart = 10.0;      // [s] least time between two of them

/// Erases every other strip, beginning with the second one. The last `kept` ones stay.
void eraseEveryOther(std::vector<SessionStrip>& strips, std::size_t kept)
{
    for (std::size_t k = 1; k + kept < strips.size(); ++k)
        strips.erase(strips.begin() + static_cast<std::ptrdiff_t>(k));
}

}  // namespace

ReviewStrip::ReviewStrip(SessionReader& reader, RobotModel robot)
    : reader_(reader), robot_(std::move(robot)), reading_(reader_, robot_), whole_{reading_}
{
}

bool ReviewStrip::readOn(SessionTime shown)
{
    const SessionTime next = std::max<SessionTime>(reading_.time(), 0) + sessionTimeOf(kPart);
    if (next > reader_.end()) return false;
    const bool wasWhole = startFor(shown).isWhole;
    reading_.goTo(next);
    if (next == std::ssize(whole_) * apart_) whole_.push_back(reading_);
    if (whole_.size() > kWholes) {
        eraseEveryOther(whole_, 0);
        apart_ *= 2;
    }
    return !wasWhole && startFor(shown).isWhole;
}

ReviewStrip::Start ReviewStrip::startFor(SessionTime time) const
{
    const auto k = static_cast<std::size_t>(time / apart_);
    if (k < whole_.size()) return {whole_[k].time(), true};
    const SessionTime step = sessionTimeOf(kStep);
    const SessionTime from = (time / step) * step - sessionTimeOf(kMinLength);
    return {std::max<SessionTime>(from, -1), from < 0};
}

ReviewStrip::ViewState ReviewStrip::at(const ReviewMoment& moment)
{
    const Start start = startFor(moment.time);
    if (followed_.empty() || start != start_) begin(start);
    while (followed_.size() > 1 && followed_.back().time() > moment.time) followed_.pop_back();
    goTo(moment.time);
    const Strip& strip = followed_.back().strip();
    return {strip.seen(), strip.earlier(), strip.whyNothing(),
            start.isWhole ? std::optional(strip.ledger()) : std::nullopt};
}

void ReviewStrip::begin(const Start& start)
{
    start_ = start;
    followed_.clear();
    const auto kept = std::ranges::find(whole_, start.time, &SessionStrip::time);
    if (start.isWhole && kept != whole_.end())
        followed_.push_back(*kept);
    else
        followed_.emplace_back(reader_, robot_, start.time);
}

void ReviewStrip::goTo(SessionTime until)
{
    const SessionTime apart = sessionTimeOf(kApart);
    while (followed_.back().time() < until) {
        const auto before = followed_.rbegin() + 1;
        if (before == followed_.rend() || followed_.back().time() - before->time() >= apart)
            followed_.push_back(followed_.back());
        if (followed_.size() > kCopies) eraseEveryOther(followed_, 2);
        followed_.back().goTo(std::min(until, followed_.back().time() + apart));
    }
}

}  // namespace terratact
