#include "core/learn/gp/lazy_processes.h"

#include <algorithm>

namespace terratact {

int rowsToInduce(int wanted, int trained, Eigen::Index rows)
{
    int count = static_cast<int>(rows);
    for (const int most : {wanted, trained})
        if (most > 0) count = std::min(count, most);
    return count;
}

const GaussianProcess&
LazyProcesses::get(int inducing, const std::function<std::unique_ptr<GaussianProcess>()>& make,
                   const Poll& poll) const
{
    Entry& entry = [&]() -> Entry& {
        const std::scoped_lock lock(mutex_);
        return entries_[inducing];
    }();
    const PolledMutex::Lock lock(entry.mutex, poll);
    if (!entry.gp) entry.gp = make();
    return *entry.gp;
}

}  // namespace terratact
