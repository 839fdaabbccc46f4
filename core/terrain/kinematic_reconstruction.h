#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"

namespace terratact {

/// A place where the robot feels the ground, DEM frame.
struct Contact {
    double x = 0.0;       ///< [m]
    double height = 0.0;  ///< [m]
    double force = 0.0;   ///< sum over its elements [N]
    int bin = 0;
};

struct KinematicReconstruction {
    OptionalHeights height{};       ///< known bins; several contacts in a bin are averaged by force
    std::vector<Contact> contacts;  ///< contacts inside the bins
    std::array<bool, kForceElements> touching{};  ///< elements that made a contact
    std::vector<Message> warnings;                ///< contacts that contradict the body
};

/// Reconstructs contact heights from pitch, flipper angle and element positions (section 4.2 of the
/// paper).
///   isolatedOnly  The contact is the force-weighted centre of exactly one element, or of one group of
///                 neighbours, above the threshold. Otherwise no contact is known.
///   else          Every element above the threshold is a contact.
/// threshold: [N]. An element without a value is below the threshold. A contact higher than another
/// part of the body at that x is kept and named in `warnings`. Throws std::invalid_argument unless
/// threshold ≥ 0.
KinematicReconstruction reconstructContacts(const RobotModel& robot, const Proprioception& s,
                                            double threshold, bool isolatedOnly);

}  // namespace terratact
