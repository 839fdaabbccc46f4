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

/// What a contact says of its bin, beside the truth.
struct ContactResidual {
    int bin = 0;
    double residual = 0.0;  ///< [m] true height of the bin − height of the contact
    bool operator==(const ContactResidual&) const = default;
};

/// One per bin that the kinematic reconstruction fixes (core/terrain/kinematic_reconstruction.h; contacts
/// that share a bin are one height there) and whose truth is known, in the scenes' order.  A contact feels
/// a point, the truth is the mean of 0.1 m: the residual holds sensor noise and that difference.
/// threshold: [N].  Throws std::invalid_argument unless threshold ≥ 0.
std::vector<ContactResidual> contactResiduals(const RobotModel& robot,
                                              std::span<const Scene> scenes, double threshold,
                                              ContactRule rule);

/// Of a set of residuals [m].  Zero everywhere when n is 0; sd is 0 when n is 1.
struct ResidualStatistics {
    std::size_t n = 0;
    double mean = 0.0;
    double sd = 0.0;        ///< about the mean, n − 1 in the denominator
    double robustSd = 0.0;  ///< 1.4826 median |x − median|: sd of a normal, deaf to single outliers
    bool operator==(const ResidualStatistics&) const = default;
};
ResidualStatistics residualStatistics(const std::vector<double>& residuals);

struct ContactSummary {
    std::array<ResidualStatistics, kBins> bin{};
    ResidualStatistics all;
};
ContactSummary summariseContacts(std::span<const ContactResidual> residuals);

/// Correction and sd that make contact heights fit the truth: h = contact + bias ± sd.
struct ContactCalibration {
    double bias = 0.0;  ///< [m] mean residual
    double sd = 0.0;    ///< [m] of the residuals; 0 when n < 2: nothing is known
    std::size_t n = 0;
    bool operator==(const ContactCalibration&) const = default;
};
ContactCalibration contactCalibration(std::span<const ContactResidual> residuals);

}  // namespace terratact
