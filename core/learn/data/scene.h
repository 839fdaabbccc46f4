#pragma once

#include <string>
#include <vector>

#include "core/robot/measurement.h"
#include "core/terrain/bins.h"

namespace terratact {

/// One measured scene: the proprioception and, if known, the true terrain.
struct Scene {
    std::string run;    ///< drive that it belongs to
    double time = 0.0;  ///< [s] since the drive's start
    Proprioception s;
    OptionalHeights truth{};
    OptionalHeights truthSd{};  ///< [m] sd of each true height; empty: exact
    bool operator==(const Scene&) const = default;
};

}  // namespace terratact
