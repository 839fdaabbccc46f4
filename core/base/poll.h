#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace terratact {

/// Cancellation callback of a long computation. An exception that it throws ends the computation.
/// May be empty.
using Poll = std::function<void()>;

inline void callPoll(const Poll& poll)
{
    if (poll) poll();
}

/// Counts work and calls a poll every kBetweenPolls units, which take some milliseconds on any
/// processor.
class PolledWork {
public:
    /// One unit takes between some and some tens of nanoseconds: one comparison, one draw, one
    /// number read.
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

/// Writes to[0 … count) = f(from[0 … count)) and calls the poll meanwhile.
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
