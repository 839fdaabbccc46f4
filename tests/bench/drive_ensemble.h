#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/sim/rest/flipper_drive.h"
#include "core/strip/dead_reckoning.h"

namespace terratact {

/// Readings that an ensemble uses: pitch, front and rear current, and at a press also the angle of
/// the front flippers and their six forces.
inline constexpr std::size_t kWayReadings = 3, kPressReadings = 4 + kForceElements;
using PressReadings = std::array<double, kPressReadings>;

/// Options of the smoother.
struct EnsembleOptions {
    Eigen::Index members = 300;
    double reach = 1.0;       ///< of taperAt(), from the base along the ground [m]
    double relaxation = 0.3;  ///< see updateEnsemble()
    /// Sd of readings that the ground's representation adds to that of the sensors: postsSd().
    PressReadings groundSd{};
};

/// Returns the sd of readings on ground through posts against the ground itself: half of the middle
/// 68 % of their differences. The poses are those of presses on randomVariedTerrain().
PressReadings postsSd(const RobotModel& robot, std::uint64_t seed);

/// An ensemble Kalman smoother over the ground of one drive in one plane. A member is a ground
/// through posts every 0.05 m and the robot's place on it. Members begin as random pieces of
/// randomVariedTerrain(), and the robot at one place of each. The state holds the rises from post
/// to post: readings do not depend on the height of the whole ground. Each stretch of the way
/// between two presses has a slip of its own in each member (RobotModel::travelledSdShare).
/// Readings are predicted by the rest pose on each member (core/sim/rest/rest_pose.h). The rear
/// flippers are held at their measured angle. The front ones are held so on the way. At a press,
/// the median of their currents so far gives the torque. A member without a rest pose becomes a
/// copy of another one. Each update changes all rises within reach, behind the robot and ahead.
class DriveEnsemble {
public:
    /// way: length of the drive along the tracks [m].
    DriveEnsemble(const RobotModel& robot, const EnsembleOptions& options, double way,
                  std::seed_seq& seed);

    /// Moves the robot to the next line on the way, which has `travelled`. The ensemble learns from a
    /// line if the robot has moved 0.12 m since it last did.
    void drive(const Measurement& line);

    /// Learns from a press. Returns height, q10 and q90 of its bins after that, none above the
    /// robot; empty: the robot finds no rest pose on any member.
    std::optional<TerrainEstimate> press(const Measurement& scene);

private:
    /// What each member predicts: one column per member.
    struct Predictions {
        Eigen::MatrixXd readings;  ///< kPressReadings rows
        Eigen::MatrixXd bins;      ///< heights of the bins in the DEM frame [m]
        std::vector<Eigen::Index> standing, fallen;
    };

    Eigen::Index members() const { return rises_.cols(); }
    void drawSlip();
    void moveTo(const Measurement& line);
    double pressTorque() const;
    Predictions predictions(const Proprioception& s, const FlipperDrive& front) const;
    void replaceFallen(Predictions& predicted);
    std::optional<Eigen::MatrixXd> learn(const Proprioception& s, const FlipperDrive& front,
                                         std::size_t readings);
    Eigen::MatrixXd update(const Predictions& predicted, const PressReadings& measured,
                           std::size_t readings);
    Eigen::VectorXd taper(Eigen::Index rows) const;

    const RobotModel& robot_;
    EnsembleOptions options_;
    std::mt19937_64 rng_;
    Eigen::MatrixXd rises_;    ///< from post to post [m], one column per member
    Eigen::RowVectorXd x_;     ///< of the base, from the first post [m]
    Eigen::RowVectorXd slip_;  ///< of the present stretch, as a share of the way
    std::optional<Odometry> odometry_;
    double since_ = 0.0;            ///< [m] since the last update
    std::vector<double> currents_;  ///< of the front flippers at presses [A]
};

}  // namespace terratact
