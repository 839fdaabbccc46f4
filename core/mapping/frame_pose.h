#pragma once

#include <Eigen/Geometry>

namespace terratact {

/// Pose of a frame in another one: p_other = turn · p + place.
struct FramePose {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< [m]
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();

    Eigen::Vector3d toOther(const Eigen::Vector3d& p) const { return turn * p + place; }
    /// Returns the pose of a frame whose pose in this frame is `mount`.
    FramePose with(const FramePose& mount) const
    {
        return {toOther(mount.place), turn * mount.turn};
    }
    FramePose inverse() const
    {
        const Eigen::Quaterniond back = turn.conjugate();
        return {-(back * place), back};
    }
};

/// Returns the pose between two: a at share 0, b at share 1. Places move evenly along a line, turns about one axis.
inline FramePose between(const FramePose& a, const FramePose& b, double share)
{
    return {a.place + share * (b.place - a.place), a.turn.slerp(share, b.turn)};
}

}  // namespace terratact
