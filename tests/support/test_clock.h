#pragma once

#include <functional>

namespace terratact {

/// Returns the time [s] of the running test's clock, which a busy machine slows down (PatientClock). Empty: the test has
/// no such clock. For the test's own thread.
inline std::function<double()> testClock;

}  // namespace terratact
