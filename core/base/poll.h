#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace terratact {

/// Asked by a long computation whether it is still wanted; what it throws ends the computation.  May be empty.
using Poll = std::function<void()>;

inline void callPoll(const Poll& poll)
{
    if (poll) poll();
}

/// Counts work and asks a poll every kBetweenPolls units of it: some milliseconds on any processor.
class PolledWork {
public:
    /// A unit is what takes some nanoseconds to some tens: a comparison of a sort, a draw, a number looked at.
    static constexpr long kBetweenPolls = 1 << 16;

    explicit PolledWork(const Poll& poll) : poll_(poll) {}

    void done(long units = 1)
    {
        left_ -= units;
        if (left_ > 0) return;
        left_ = kBetweenPolls;
        callPoll(poll_);
    }

private:
    const Poll& poll_;
    long left_ = kBetweenPolls;
};

/// to[0 … count) = f(from[0 … count)), asking the poll meanwhile.
template <class T, class F>
void transformPolled(const T* from, std::ptrdiff_t count, T* to, PolledWork& work, F f)
{
    while (count > 0) {
        const std::ptrdiff_t some = std::min<std::ptrdiff_t>(count, PolledWork::kBetweenPolls);
        to = std::transform(from, from + some, to, f);
        from += some;
        count -= some;
        work.done(some);
    }
}

}  // namespace terratact
