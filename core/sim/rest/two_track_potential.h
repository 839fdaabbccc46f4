#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "core/robot/two_tracks.h"
#include "core/sim/rest/flipper_drive.h"
#include "core/sim/rest/ground_contact.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

/// Coordinates of a two-track pose in gradients. The angles of an axle's flippers are mean + half
/// (left) and mean − half (right). The first four are then those of the plane. The others are 0 on
/// ground that is equal on both sides.
struct TwoTrackCoordinate {
    enum : int { Z, Pitch, FrontMean, RearMean, Roll, FrontHalf, RearHalf, Differential, Count };
};
using TwoTrackVector = Eigen::Matrix<double, TwoTrackCoordinate::Count, 1>;
using TwoTrackMatrix = Eigen::Matrix<double, TwoTrackCoordinate::Count, TwoTrackCoordinate::Count>;

struct TwoTrackDerivatives {
    TwoTrackVector gradient;  ///< [N] and [N m]
    TwoTrackMatrix hessian;
};

/// Contacts of both sides: left, right.
using SideContacts = std::array<std::vector<GroundContact>, 2>;

/// Potential energy of a robot with two tracks on lines of ground [J]:
///   E = m g z_body + Σ flippers (½ m g z + τ θ) + Σ sides ½ (compressed skin)
/// as in the plane (restPose() of core/sim/rest/rest_pose.h). Each side carries half of the stiffness
/// of a point. Each track and each flipper stands over the line at its y (sidePose()). The body's
/// polygons stand over both tracks' lines, so that equal lines carry them as the plane does. Higher
/// ground between the tracks is unknown and does not carry the robot. Friction holds x.
class TwoTrackPotential {
public:
    /// drives: torques of single flippers.
    TwoTrackPotential(const RobotModel& robot, const GroundLines& terrain, double x,
                      const PerFlipper<FlipperDrive>& drives, const GroundOptions& ground);

    /// Returns the energy [J]. stiffness: of a point of both sides together [N/m]. derivatives and
    /// contacts may be null.
    double operator()(const TwoTrackPose& pose, double stiffness, TwoTrackDerivatives* derivatives,
                      SideContacts* contacts) const;

    /// Returns the least height of the base at which no part touches its line.
    double clearHeight(TwoTrackPose pose) const;

    /// Returns how many ground points were sampled or compared with a part.
    std::size_t terrainPoints() const { return terrainPoints_; }

private:
    struct SideSum;
    struct Part;
    SideSum oneSide(const TwoTrackPose& pose, Side side, double stiffness,
                    std::vector<GroundContact>* contacts) const;
    double bodyWeight(const TwoTrackPose& pose, TwoTrackDerivatives& sum) const;
    void addFlipper(SideSum& sum, const TwoTrackPose& pose, Flipper flipper, double stiffness,
                    std::vector<GroundContact>* contacts) const;
    void addTrackAndBody(SideSum& sum, const TwoTrackPose& pose, Side side, double stiffness,
                         std::vector<GroundContact>* contacts) const;
    template <class Hull>
    double addSkin(Part& part, const Hull& hull, const std::vector<Vec2>& line, double stiffness,
                   std::vector<GroundContact>* contacts) const;
    const std::vector<Vec2>& trackLine(Side side) const;
    const std::vector<Vec2>& flipperLine(Side side) const;

    const RobotModel& robot_;
    PerFlipper<double> torques_{};
    GroundOptions ground_;                    ///< of one side
    std::array<std::vector<Vec2>, 4> lines_;  ///< tracks left and right, flippers left and right
    mutable std::size_t terrainPoints_ = 0;
};

}  // namespace terratact
