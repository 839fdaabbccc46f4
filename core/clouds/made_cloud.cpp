#include "core/clouds/made_cloud.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace terratact {
namespace {

constexpr double kHalfSwath = 0.4;  // [m]
constexpr double kMaxMade = 1e8;    // points

struct CloudHole {
    double x = 0.0, y = 0.0, radius = 0.0;
};

std::vector<CloudHole> holesIn(double begin, double end, double share, std::mt19937_64& rng)
{
    std::uniform_real_distribution<double> x(begin, end), y(-kHalfSwath, kHalfSwath),
        radius(0.05, 0.15);
    std::vector<CloudHole> holes;
    for (double area = share * (end - begin) * 2.0 * kHalfSwath; area > 0.0;) {
        holes.push_back({x(rng), y(rng), radius(rng)});
        area -= std::numbers::pi * holes.back().radius * holes.back().radius;
    }
    return holes;
}

bool isInHole(const std::vector<CloudHole>& holes, double x, double y)
{
    for (const CloudHole& hole : holes)
        if (std::hypot(x - hole.x, y - hole.y) < hole.radius) return true;
    return false;
}

}  // namespace

CloudPose basePose(const RobotModel& robot, const TwoTrackPose& pose)
{
    const double height = robot.trackRadius - robot.trackZ;
    const Eigen::Quaterniond turn = Eigen::AngleAxisd(-pose.pitch, Eigen::Vector3d::UnitY())
                                  * Eigen::AngleAxisd(pose.roll, Eigen::Vector3d::UnitX());
    return {{pose.base.x, -height * std::sin(pose.roll), pose.base.z}, turn};
}

std::vector<CloudPoint> groundCloud(const RobotModel& robot, const GroundLines& ground,
                                    const CloudPose& drive, double begin, double end,
                                    const MadeCloud& made, std::mt19937_64& rng)
{
    if (!(begin < end)) throw std::invalid_argument("groundCloud: begin must be before end");
    const double wanted = made.density * (end - begin) * 2.0 * kHalfSwath;
    if (!(wanted >= 0.0 && wanted <= kMaxMade))
        throw std::invalid_argument("groundCloud: too many points");
    const double edge = robot.lateral.trackY + 0.5 * robot.lateral.trackWidth;
    const auto holes = holesIn(begin, end, made.holes, rng);
    std::uniform_real_distribution<double> alongX(begin, end), acrossY(-kHalfSwath, kHalfSwath);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<CloudPoint> points;
    points.reserve(static_cast<std::size_t>(wanted));
    for (auto left = static_cast<std::size_t>(wanted); left > 0; --left) {
        const double x = alongX(rng), y = acrossY(rng), error = made.noise * noise(rng);
        if (isInHole(holes, x, y)) continue;
        const double under = std::abs(y) < edge ? robot.lateral.trackY : robot.lateral.flipperY;
        const Eigen::Vector3d p = drive.toOther(
            {x, y, ground.under(std::copysign(under, y)).heightAt(x) + error + made.offset});
        points.push_back({p.x(), p.y(), p.z()});
    }
    return points;
}

std::vector<CloudPoint> robotCloud(const RobotModel& robot, const CloudPose& base,
                                   std::size_t count, std::mt19937_64& rng)
{
    const LateralGeometry& l = robot.lateral;
    const double edge = robot.trackZ - robot.trackRadius;
    std::uniform_real_distribution<double> x(-0.5 * robot.trackAxle, 0.5 * robot.trackAxle),
        y(-l.flipperY, l.flipperY), z(edge + 0.05, edge + 0.15);
    std::vector<CloudPoint> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector3d own(x(rng), y(rng), z(rng));
        const Eigen::Vector3d p = base.toOther(own);
        points.push_back({p.x(), p.y(), p.z()});
    }
    return points;
}

std::string pcdText(std::span<const CloudPoint> points)
{
    std::string text =
        fmt::format("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\n"
                    "SIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {0}\nHEIGHT 1\n"
                    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {0}\nDATA binary\n",
                    points.size());
    text.reserve(text.size() + 12 * points.size());
    for (const CloudPoint& p : points)
        for (const double value : {p.x, p.y, p.z}) {
            const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
            for (unsigned shift = 0; shift < 32; shift += 8)
                text += static_cast<char>((bits >> shift) & 0xffU);
        }
    return text;
}

}  // namespace terratact
