#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "core/base/polled_mutex.h"
#include "core/learn/gp/gaussian_process.h"

namespace terratact {

/// Returns the number of inducing rows of a process over `rows` rows. It is at most `wanted` and at
/// most `trained`; 0 means no limit.
int rowsToInduce(int wanted, int trained, Eigen::Index rows);

/// One bin's Gaussian processes, by number of inducing rows, each made when it is first needed. It
/// may be shared between threads; the result of get() stays valid.
class LazyProcesses {
public:
    /// Returns the process. An exception of make() leaves the making to the next caller. poll:
    /// called while another thread makes it.
    const GaussianProcess& get(int inducing,
                               const std::function<std::unique_ptr<GaussianProcess>()>& make,
                               const Poll& poll) const;

private:
    struct Entry {
        PolledMutex mutex;  // held while the process is made
        std::unique_ptr<GaussianProcess> gp;
    };
    mutable std::mutex mutex_;  // guards the map; not held while a process is made
    mutable std::map<int, Entry> entries_;
};

}  // namespace terratact
