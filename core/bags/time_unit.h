#pragma once

namespace terratact {

/// Unit of the times in a recording.
struct TimeUnit {
    const char* name;      ///< s, ms, us or ns, as mappings have it
    double seconds = 1.0;  ///< of one unit
};

/// Returns the unit of times from the first of them and the usual step between two; step 0: there is none. The size
/// decides where it gives a day from 2001 to 2099, and the steps are those of a recording. Else the steps decide: a
/// robot writes between one line in half a second and one in half a millisecond. Steps of at most 1 are seconds.
TimeUnit timeUnitOf(double first, double step);

}  // namespace terratact
