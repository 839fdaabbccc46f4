#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "core/base/polled_mutex.h"
#include "core/learn/gp/gaussian_process.h"

namespace terratact {

/// Inducing rows of a process over `rows` rows: at most `wanted` and at most `trained` of them, each unless it is 0.
int rowsToInduce(int wanted, int trained, Eigen::Index rows);

/// One bin's Gaussian process for every number of inducing rows that was asked for, each made once, when first
/// needed.  Safe to share between threads; what get() returned stays where it is.
class LazyProcesses {
public:
    /// What make() throws leaves the making to the next caller.  poll: while another thread makes it.
    const GaussianProcess& get(int inducing,
                               const std::function<std::unique_ptr<GaussianProcess>()>& make,
                               const Poll& poll) const;

private:
    struct Entry {
        PolledMutex mutex;  // of the making
        std::unique_ptr<GaussianProcess> gp;
    };
    mutable std::mutex mutex_;  // of the map; an entry's making does not hold it
    mutable std::map<int, Entry> entries_;
};

}  // namespace terratact
