#pragma once

#include <string>
#include <vector>

#include "core/infer/estimate/settings.h"
#include "core/robot/measurement.h"

namespace terratact {

/// Grounds of a probe's approval: a change of any of them voids the approval.
struct ProbeGrounds {
    Measurement scene;
    std::vector<ArmReading> readings;  ///< readings of the arm at this pose
    Settings settings;                 ///< settings of the estimate
    Settings wanted;    ///< settings for the next estimate, as the operator has set them
    std::string model;  ///< identifies the model
    int bin = 0;        ///< bin to probe
    ProbeSide side = ProbeSide::Middle;
};

/// Returns the SHA-256 of the grounds as 64 hexadecimal digits; equal grounds give the same on
/// every machine.
std::string fingerprint(const ProbeGrounds& grounds);

}  // namespace terratact
