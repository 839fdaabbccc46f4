#pragma once

#include <string>
#include <vector>

#include "core/infer/estimate/settings.h"
#include "core/robot/measurement.h"

namespace terratact {

/// All that the operator's word for a probe rests on: change any of it, and the word is void.
struct ProbeGrounds {
    Measurement scene;
    std::vector<ArmReading> readings;  ///< of the arm at this pose
    Settings settings;                 ///< of the estimate
    Settings wanted;                   ///< as the operator has set them by then, for the next
    std::string model;                 ///< what tells the model from any other
    int bin = 0;                       ///< to be probed
};

/// SHA-256 of the grounds as 64 hexadecimal digits; equal for equal grounds on every machine.
std::string fingerprint(const ProbeGrounds& grounds);

}  // namespace terratact
