#include "core/terrain/kinematic_reconstruction.h"

#include <optional>
#include <stdexcept>

#include "core/robot/kinematics.h"

namespace terratact {

namespace {

/// A contact this far above another part of the robot is impossible [m].
constexpr double kContradiction = 0.01;

/// Neighbouring elements above the threshold, as [first, last].
struct Group {
    int first = 0;
    int last = 0;
};

double forceOf(const Proprioception& s, int element)
{
    return s.force[static_cast<std::size_t>(element)].value_or(0.0);
}

std::vector<Group> groupsAbove(const Proprioception& s, double threshold)
{
    std::vector<Group> groups;
    for (int e = 0; e < kForceElements; ++e) {
        if (!(forceOf(s, e) > threshold)) continue;
        if (!groups.empty() && groups.back().last == e - 1)
            groups.back().last = e;
        else
            groups.push_back({e, e});
    }
    return groups;
}

/// Returns the force-weighted centre of a group on the flipper's edge; empty outside the bins.
std::optional<Contact> contactOf(const RobotModel& robot, const Pose& pose, const Proprioception& s,
                                 Group group)
{
    double force = 0.0;
    double moment = 0.0;
    for (int e = group.first; e <= group.last; ++e) {
        force += forceOf(s, e);
        moment += forceOf(s, e) * robot.elementShare[static_cast<std::size_t>(e)];
    }
    const Vec2 p = elementPosition(robot, pose, moment / force);
    const std::optional<int> bin = binOf(p.x);
    if (!bin) return std::nullopt;
    return Contact{p.x, p.z, force, *bin};
}

void fixBins(KinematicReconstruction& result)
{
    std::array<double, kBins> force{};
    std::array<double, kBins> moment{};
    for (const Contact& c : result.contacts) {
        const auto bin = static_cast<std::size_t>(c.bin);
        force[bin] += c.force;
        moment[bin] += c.force * c.height;
        result.height[bin] = moment[bin] / force[bin];
    }
}

}  // namespace

KinematicReconstruction reconstructContacts(const RobotModel& robot, const Proprioception& s,
                                            double threshold, bool isolatedOnly)
{
    if (!(threshold >= 0.0)) throw std::invalid_argument("the force threshold must be 0 N or more");
    std::vector<Group> groups = groupsAbove(s, threshold);
    if (isolatedOnly && groups.size() != 1) return {};
    if (!isolatedOnly) {
        std::vector<Group> single;
        for (const Group g : groups)
            for (int e = g.first; e <= g.last; ++e) single.push_back({e, e});
        groups = std::move(single);
    }

    const Pose pose = poseInDem(robot, s.pitch, s.front, s.rear);
    const RobotShape shape = shapeAt(robot, pose);
    KinematicReconstruction result;
    for (const Group group : groups) {
        for (int e = group.first; e <= group.last; ++e)
            result.touching[static_cast<std::size_t>(e)] = true;
        const std::optional<Contact> contact = contactOf(robot, pose, s, group);
        if (!contact) continue;
        const double body = lowerEnvelope(shape, contact->x);
        if (contact->height > body + kContradiction)
            result.warnings.emplace_back(
                TR_NOOP("core", "contact at x %1 m lies %2 mm above the robot's own lower edge"),
                signedFixed(contact->x, 2), fixed(1000.0 * (contact->height - body), 0));
        result.contacts.push_back(*contact);
    }
    fixBins(result);
    return result;
}

}  // namespace terratact
