#pragma once

#include <cstdint>
#include <random>

#include "core/robot/command.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/sim/rest_pose.h"
#include "core/sim/sensor_noise.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// A robot that lives on a TerrainProfile and obeys commands, in steps of time given from outside.
/// Quasi-static: at every step it is at rest (core/sim/rest_pose.h).  Not thread-safe.
class SimulatedRobot {
public:
    struct Options {
        double startX = 0.0;        ///< [m] base origin on the terrain
        double rearAngle = 0.1;     ///< [rad] held
        double drivingAngle = 0.7;  ///< [rad] front flippers while driving
        double probeSeconds = 45.0;
        SensorNoise noise;
        /// Share of a way by which the tracks report too much or too little: drawn anew whenever the robot
        /// starts to drive, from N(0, slipShare²).
        double slipShare = 0.10;
        std::uint64_t seed = 1;
    };

    SimulatedRobot(RobotModel robot, TerrainProfile terrain, const Options& options);

    /// Takes or refuses a command; a refusal is in the next measure().  Arming is the link's business, so it
    /// changes nothing here; the beginning and the end of an exploration halt.
    void command(const Command& command);

    /// Lets `dt` seconds pass.  Throws std::invalid_argument unless 0 < dt ≤ 1.
    void step(double dt);

    /// One line of telemetry with sensor noise.
    Measurement measure();

    /// True bin heights at the present pose.
    Heights truth() const;

    const RestPose& rest() const { return rest_; }
    RobotActivity activity() const { return activity_; }

private:
    bool settle();
    void obey(const DriveCommand& drive);
    void obey(const PressCommand& press);
    void obey(const ProbeCommand& probe);
    void obey(const AdvanceCommand& advance);
    void obey(const HoldFlippersCommand& hold);
    void halt();
    bool standsStill() const;
    void drive(double dt);
    void press(double turn);
    void probe(double dt);
    void hold(double turn);
    void accept(RobotActivity activity);
    void refuse(Refusal refusal);
    void startDriving(double speed);
    void moveBy(double way);

    RobotModel robot_;
    TerrainProfile terrain_;
    Options options_;
    std::mt19937_64 rng_;
    std::mt19937_64 slipRng_;  ///< of its own: no sensor's noise depends on how often it drives
    std::mt19937_64 rollRng_;  ///< of its own, too
    RestPose rest_;
    double time_ = 0.0;
    double x_ = 0.0;
    double speed_ = 0.0;
    double frontTarget_ = 0.0;                 ///< [rad] held angle while not pressed
    double rearTarget_ = 0.0;                  ///< [rad] held angle
    std::optional<HoldFlippersCommand> hold_;  ///< where the flippers are going while halted
    std::optional<double> advanceLeft_;        ///< [m] while driving a given distance
    double torque_ = 0.0;  ///< [N m] both front flippers while pressing or pressed
    RobotActivity activity_ = RobotActivity::Halted;
    Refusal refusal_ = Refusal::None;
    int probeBin_ = 0;
    double probeLeft_ = 0.0;
    std::optional<ArmReading> arm_;
    double slip_ = 0.0;       ///< share of the way that the tracks report too much
    double travelled_ = 0.0;  ///< [m] as the tracks report it
};

}  // namespace terratact
