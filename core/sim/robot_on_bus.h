#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/robot/robot_model.h"
#include "core/sim/sensor_fault.h"
#include "core/sim/simulated_robot.h"
#include "core/wire/can_frame.h"
#include "core/wire/command_receiver.h"

namespace terratact {

/// Fault of a simulated robot on request.
///   Silence      sends and receives nothing
///   StuckImu     pitch and roll keep their values
///   DeadElement  element 4, left if there is one there, reads 0 V: its wire is open
///   RefuseProbe  refuses every probe as out of reach
///   SlowArm      takes three times as long for a probe
///   Reboot       is absent for a second, then restarts: new epoch, disarmed, halted, no exploration
enum class RobotFault : std::uint8_t {
    None,
    Silence,
    StuckImu,
    DeadElement,
    RefuseProbe,
    SlowArm,
    Reboot
};
inline constexpr std::array kRobotFaults{
    RobotFault::None,        RobotFault::Silence, RobotFault::StuckImu, RobotFault::DeadElement,
    RobotFault::RefuseProbe, RobotFault::SlowArm, RobotFault::Reboot};

/// Returns "none", "silence", "stuck-imu", "dead-element", "refuse-probe", "slow-arm" or "reboot".
std::string_view name(RobotFault fault);
std::optional<RobotFault> robotFaultFromName(std::string_view text);

/// Simulated robot behind the protocol of resources/dbc/terratact.dbc. It obeys and refuses as a
/// real one must, sends telemetry every 50 ms and answers heartbeats. It halts by watchdog or
/// dead-man when its console falls silent. It has no clock: `now` is monotonic time [s]; a time
/// before the last one counts as no time passed.
class RobotOnBus {
public:
    struct Options {
        std::uint8_t firstEpoch = 1;       ///< random at every start, not 0
        std::uint16_t firstChallenge = 1;  ///< random at every start, not 0
        double speed = 1.0;                ///< simulated seconds per second
        RobotFault fault = RobotFault::None;
        double faultAt = 0.0;                      ///< [s] after the first tick
        std::optional<SensorFault> sensorFault{};  ///< active from faultAt on, too
    };
    static constexpr double kPeriod = 0.05;     ///< [s] of telemetry
    static constexpr double kRebootTime = 1.0;  ///< [s]
    static constexpr double kMaxTick = 0.2;  ///< [s] largest time that a late tick catches up with

    /// Throws std::invalid_argument for epoch or challenge 0, and unless 0 < speed ≤ 1000 and
    /// faultAt ≥ 0.
    RobotOnBus(RobotModel model, SimulatedRobot robot, const Options& options);

    /// Returns the frames that answer one frame.
    std::vector<CanFrame> receive(const CanFrame& frame, double now);

    /// Advances the time to `now` and returns the frames sent by then. Call it at least every 50
    /// ms.
    std::vector<CanFrame> tick(double now);

    const SimulatedRobot& robot() const { return robot_; }
    bool armed() const { return receiver_.armed(); }
    std::uint8_t epoch() const { return receiver_.epoch(); }

private:
    bool faulty(RobotFault fault) const;
    bool mute() const;
    void obey(const Command& command);
    void refuse(Refusal refusal) { refusal_ = refusal; }
    void haltForSilence(CommandReceiver::Silence silence);
    void live(double dt);
    void reboot();
    Measurement measured();
    std::vector<CanFrame> telemetry();

    RobotModel model_;
    SimulatedRobot robot_;
    Options options_;
    CommandReceiver receiver_;
    std::optional<double> began_, last_;  ///< first and newest tick [s]
    double due_ = 0.0;                    ///< time of the next telemetry [s]
    bool rebooted_ = false;
    bool exploring_ = false;
    std::optional<Refusal> refusal_;  ///< refusal by the link; empty: the robot's own
    std::optional<FrameKind> lastCommand_;
    std::uint8_t lastCounter_ = 0;
    std::uint8_t telemetryCounter_ = 0, heartbeatCounter_ = 0;
    std::optional<Measurement> stuck_;
    std::optional<FaultySensors> faultySensors_;
};

}  // namespace terratact
