#include "core/strip/scene_contacts.h"

#include "core/robot/side_plane.h"

namespace terratact {

std::array<std::vector<Contact>, 2> sceneContacts(const RobotModel& robot, const Measurement& scene,
                                                  bool onePlane, const Settings& settings)
{
    if (settings.contacts == ContactRule::None) return {};
    const auto contactsOf = [&](const RobotModel& plane, const Proprioception& s) {
        return reconstructContacts(plane, s, settings.forceThreshold,
                                   settings.contacts == ContactRule::Isolated)
            .contacts;
    };
    if (onePlane) return {contactsOf(robot, proprioception(scene)), {}};
    const auto ofSide = [&](Side side) {
        return contactsOf(inSidePlane(robot, scene.roll, signOf(side) * robot.lateral.flipperY),
                          sideReadings(twoTrackReadings(scene), side));
    };
    return {ofSide(Side::Left), ofSide(Side::Right)};
}

}  // namespace terratact
