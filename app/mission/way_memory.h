#pragma once

#include <optional>
#include <vector>

#include "app/mission/trail_networks.h"
#include "core/base/message.h"
#include "core/infer/estimate/variant.h"
#include "core/robot/watch/sensor_suspicion.h"
#include "core/trail/trail_record.h"

namespace terratact {

/// Memory of the way before a scene.
struct SceneMemory {
    std::optional<TrailHistory> history{};  ///< empty: nothing that an estimate can use
    Message why{};                          ///< reason for an empty history
};

/// The memory of the way (core/trail/trail_record.h), fed by telemetry. A break of the way clears it: a silence, a jump
/// of the odometry or a turn (core/strip/strip_way.h). The operator can clear it, too. It is also cleared while a
/// sensor that it needs is suspected.
class WayMemory {
public:
    explicit WayMemory(const RobotModel& robot) : record_(robot) {}

    /// Adds the next line of telemetry. suspicions: of that line.
    void add(const Measurement& line, const std::vector<SensorSuspicion>& suspicions);
    /// Forgets the way because telemetry was silent for too long by the caller's clock.
    void addSilence() { record_.addSilence(); }
    /// Forgets the way because the operator has cleared the ground.
    void clear() { record_.end(SectionStart::Cleared); }

    /// Returns the memory of the way before a scene.
    SceneMemory before(const Measurement& scene) const;
    /// Keeps the presses of a scene for the scenes after it. The scene counts as a line of telemetry.
    void addScene(const Measurement& scene) { record_.addScene(scene); }
    /// Returns the arm's readings of the newest scene, including those before a press in place.
    std::vector<ArmReading> armHere() const { return record_.armHere(); }
    /// Forgets what was felt, because a sensor is suspected.
    void forgetFelt() { record_.forgetFelt(); }
    /// Keeps a reading of the arm at the last scene for the scenes after it.
    void addArm(const Measurement& scene, const ArmReading& reading)
    {
        record_.addArm(scene, reading);
    }

private:
    Message why() const;

    TrailRecord record_;
};

/// Returns the method that estimates: Trail needs networks and a memory, otherwise Local estimates.
Method methodWith(Method wanted, const SceneMemory& memory, const TrailInUse& networks);

}  // namespace terratact
