#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/infer/estimate/variant.h"
#include "core/learn/data/scene.h"
#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Difference of a bin's true height and its contact height.
struct ContactResidual {
    int bin = 0;
    double residual = 0.0;  ///< [m] true height of the bin − height of the contact
    bool operator==(const ContactResidual&) const = default;
};

/// Returns one residual per bin that the kinematic reconstruction fixes
/// (core/terrain/kinematic_reconstruction.h) and whose truth is known, in the scenes' order.
/// Contacts in one bin are one height there. A contact is a point, but the truth is the mean of 0.1
/// m. The residual holds sensor noise and that difference. threshold: [N]. Throws
/// std::invalid_argument unless threshold ≥ 0.
std::vector<ContactResidual> contactResiduals(const RobotModel& robot,
                                              std::span<const Scene> scenes, double threshold,
                                              ContactRule rule);

/// Statistics of residuals [m]. All are zero if n is 0; sd is 0 if n is 1.
struct ResidualStatistics {
    std::size_t n = 0;
    double mean = 0.0;
    double sd = 0.0;  ///< about the mean, n − 1 in the denominator
    /// 1.4826 median |x − median|: sd of a normal, robust to single outliers
    double robustSd = 0.0;
    bool operator==(const ResidualStatistics&) const = default;
};
ResidualStatistics residualStatistics(const std::vector<double>& residuals);

struct ContactSummary {
    std::array<ResidualStatistics, kBins> bin{};
    ResidualStatistics all;
};
ContactSummary summariseContacts(std::span<const ContactResidual> residuals);

}  // namespace terratact
