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

/// What goes wrong with a robot on request.
///   Silence      sends nothing any more, and hears nothing
///   StuckImu     pitch and roll stay what they were
///   DeadElement  element 4, left where there is one there, reads 0 V: its wire is open
///   RefuseProbe  refuses every probe as out of reach
///   SlowArm      takes three times as long for a probe
///   Reboot       is gone for a second, then begins anew: another epoch, disarmed, halted, nothing explored
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

/// "none", "silence", "stuck-imu", "dead-element", "refuse-probe", "slow-arm", "reboot".
std::string_view name(RobotFault fault);
std::optional<RobotFault> robotFaultFromName(std::string_view text);

/// A simulated robot behind the protocol of resources/dbc/terratact.dbc: obeys and refuses as a real one
/// has to, sends telemetry every 50 ms, answers heartbeats, and halts when its console falls silent.
/// No clock: `now` is monotonic time [s]; earlier times than before count as no time passed.
class RobotOnBus {
public:
    struct Options {
        std::uint8_t firstEpoch = 1;       ///< drawn anew at every start, not 0
        std::uint16_t firstChallenge = 1;  ///< drawn anew at every start, not 0
        double speed = 1.0;                ///< simulated seconds per second
        RobotFault fault = RobotFault::None;
        double faultAt = 0.0;                      ///< [s] after the first tick
        std::optional<SensorFault> sensorFault{};  ///< from faultAt on, too
    };
    static constexpr double kPeriod = 0.05;     ///< [s] of telemetry
    static constexpr double kRebootTime = 1.0;  ///< [s]
    static constexpr double kMaxTick = 0.2;     ///< [s] of time that a late tick catches up with

    /// Throws std::invalid_argument for epoch or challenge 0, or unless 0 < speed ≤ 1000 and faultAt ≥ 0.
    RobotOnBus(RobotModel model, SimulatedRobot robot, const Options& options);

    /// What the robot sends in answer to one frame.
    std::vector<CanFrame> receive(const CanFrame& frame, double now);

    /// Lets time pass until `now`.  What the robot sends by then; to be called at least every 50 ms.
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
    std::optional<double> began_, last_;  ///< [s] the first and the newest tick
    double due_ = 0.0;                    ///< [s] of the next telemetry
    bool rebooted_ = false;
    bool exploring_ = false;
    std::optional<Refusal> refusal_;  ///< of the link; else the robot's own
    std::optional<FrameKind> lastCommand_;
    std::uint8_t lastCounter_ = 0;
    std::uint8_t telemetryCounter_ = 0, heartbeatCounter_ = 0;
    std::optional<Measurement> stuck_;
    std::optional<FaultySensors> faultySensors_;
};

}  // namespace terratact
