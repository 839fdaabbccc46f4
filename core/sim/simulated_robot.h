#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>

#include "core/robot/command.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/sim/robot_stance.h"
#include "core/sim/sensor_noise.h"
#include "core/terrain/ground_lines.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Robot on simulated ground that obeys commands, in time steps from outside. It is quasi-static: at
/// every step it is at rest (core/sim/robot_stance.h). Where the ground differs left and right, roll,
/// flipper angles, currents and forces are those of both sides. Not thread-safe.
class SimulatedRobot {
public:
    struct Options {
        double startX = 0.0;        ///< [m] base origin on the terrain
        double rearAngle = 0.1;     ///< [rad] held
        double drivingAngle = 0.7;  ///< [rad] front flippers while driving
        /// [rad] front flippers in an advance of at most 0.1 m. Their tips then come no further ahead
        /// than those of flat flippers before it. Flippers that pressed at a steep angle reached less far. So the tips
        /// can meet a wall that was not felt.
        double advancingAngle = 1.2;
        double probeSeconds = 45.0;
        SensorNoise noise;
        /// Relative error of the tracks' odometry: drawn from N(0, slipShare²) whenever the robot
        /// starts to drive.
        double slipShare = 0.10;
        std::uint64_t seed = 1;
        GroundOptions ground{};  ///< stiffness, and a soft layer
    };

    SimulatedRobot(RobotModel robot, GroundLines ground, const Options& options);
    /// Stands on ground that is equal left and right.
    SimulatedRobot(RobotModel robot, TerrainProfile terrain, const Options& options);

    /// Accepts or refuses a command; the next measure() reports a refusal. Arming belongs to the
    /// link and changes nothing here. The begin and the end of an exploration halt the robot.
    void command(const Command& command);

    /// Advances the time by `dt` seconds. Throws std::invalid_argument unless 0 < dt ≤ 1.
    void step(double dt);

    /// Returns one line of telemetry with sensor noise.
    Measurement measure();

    /// Returns the true bin heights at the present pose: of one side, or the means of both.
    Heights truth(ProbeSide side = ProbeSide::Middle) const { return stance_.truth(side); }

    /// Returns the pose in the vertical plane of the middle.
    const Pose& pose() const { return stance_.pose(); }
    const RobotStance& stance() const { return stance_; }
    RobotActivity activity() const { return activity_; }

private:
    bool settle();
    Measurement planeReadings();
    Measurement trackReadings();
    void keepFrontAngles();
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
    RobotStance stance_;
    Options options_;
    std::mt19937_64 rng_;
    std::mt19937_64 slipRng_;  ///< separate: the number of drives must not change the sensor noise
    std::mt19937_64 rollRng_;  ///< separate: the roll must not change the sensor noise
    std::mt19937_64 sideRng_;  ///< separate: differences of the sides must not change their mean
    double time_ = 0.0;
    double x_ = 0.0;
    double speed_ = 0.0;
    std::array<double, 2> frontTargets_{};     ///< [rad] held angles by side, while not pressed
    bool isRaisedToAdvance_ = false;           ///< an advance raised the front flippers
    std::array<bool, 2> hasPressed_{};         ///< sides that have the torque of the present press
    double rearTarget_ = 0.0;                  ///< [rad] held angle
    std::optional<HoldFlippersCommand> hold_;  ///< target of the flippers while halted
    std::optional<double> advanceLeft_;  ///< remaining way of a drive over a given distance [m]
    double torque_ = 0.0;  ///< torque of both front flippers while pressing or pressed [N m]
    RobotActivity activity_ = RobotActivity::Halted;
    Refusal refusal_ = Refusal::None;
    ProbeCommand probe_;
    double probeLeft_ = 0.0;
    std::optional<ArmReading> arm_;
    double slip_ = 0.0;       ///< share of the way that the tracks report in excess
    double travelled_ = 0.0;  ///< as the tracks report it [m]
};

}  // namespace terratact
