#include "app/modelling/robots/robot_calibration.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace terratact {
namespace {

using P = FloorParameter;
using Square = Eigen::Matrix<double, P::Count, P::Count>;

constexpr double kModelSd = 0.002;      // [rad] floor, tracks and structure give way
constexpr double kEncoderSd = 0.004;    // [rad] play of a flipper's drive
constexpr double kLoadedCurrent = 1.0;  // [A]
constexpr double kMaxTorqueSd = 0.1;    // share of an identified torque
constexpr double kOutlier = 4.0;        // [sd]
constexpr std::size_t kMinPoses = 3;
constexpr std::array<double Measurement::*, kFlippers> kAngles{
    &Measurement::frontLeft, &Measurement::frontRight, &Measurement::rearLeft,
    &Measurement::rearRight};

FloorParameters priorSd()
{
    FloorParameters sd;
    sd << 0.02, 0.03, 0.03, 0.003, 0.003, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1;
    return sd;
}

/// The equations of a pose at given parameters, without slopes.
struct PoseResiduals {
    std::array<double, 6> value{};  ///< pitch, roll, four tips; over their sd
    std::array<bool, 6> is{};
};

class FloorFit {
public:
    FloorFit(const RobotModel& robot, const std::vector<StandingPose>& poses)
        : robot_(robot), poses_(poses), prior_(parametersOf(robot)), isUsed_(poses.size(), true)
    {
    }

    /// Descends from a start. Returns half of the sum of squares.
    double descend(FloorParameters& x)
    {
        double lambda = 1e-3, cost = costOf(x);
        for (int i = 0; i < 60 && lambda < 1e9; ++i) {
            Square A;
            FloorParameters b;
            normalEquations(x, A, b);
            Square damped = A;
            damped.diagonal() *= 1.0 + lambda;
            const FloorParameters step = damped.ldlt().solve(-b);
            const double next = costOf(x + step);
            if (next < cost) {
                const bool isDone = cost - next < 1e-9 * (1.0 + cost);
                x += step;
                cost = next;
                lambda *= 0.3;
                if (isDone) break;
            } else {
                lambda *= 5.0;
            }
        }
        return cost;
    }

    /// Fits from several lengths of the track: a wheel that a flipper's pivot hides has no slope.
    FloorParameters best()
    {
        FloorParameters best = prior_;
        double least = std::numeric_limits<double>::infinity();
        for (const double longer : {0.0, 0.01, 0.025, -0.02}) {
            FloorParameters x = prior_;
            x[P::TrackAxle] += longer;
            if (const double cost = descend(x); cost < least) least = cost, best = x;
        }
        return best;
    }

    /// Leaves out poses that lie far off, measured by the scatter of all. Returns true if their number changed.
    bool leaveOut(const FloorParameters& x)
    {
        const std::array<double, 3> scale{scatterOf(x, 0), scatterOf(x, 1), scatterOf(x, 2)};
        bool changed = false;
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            const auto r = residualsOf(poses_[i], x);
            bool fits = r.has_value();
            for (std::size_t k = 0; fits && k < r->value.size(); ++k)
                fits = !r->is[k] || std::abs(r->value[k]) <= kOutlier * scale.at(kindOf(k));
            changed |= fits != isUsed_[i];
            isUsed_[i] = fits;
        }
        return changed;
    }

    Square covariance(const FloorParameters& x) const
    {
        Square A;
        FloorParameters b;
        normalEquations(x, A, b);
        const Square inverse = A.ldlt().solve(Square::Identity());
        std::size_t n = 0;
        double sum = 0.0;
        for (std::size_t i = 0; i < poses_.size(); ++i)
            if (const auto r = residualsOf(poses_[i], x); isUsed_[i] && r)
                for (std::size_t k = 0; k < r->value.size(); ++k)
                    if (r->is[k]) sum += r->value[k] * r->value[k], ++n;
        const double scatter = n > P::Count ? sum / static_cast<double>(n - P::Count) : 1.0;
        return std::max(1.0, scatter) * inverse;
    }

    std::size_t used() const
    {
        return static_cast<std::size_t>(std::count(isUsed_.begin(), isUsed_.end(), true));
    }
    bool isUsed(std::size_t pose) const { return isUsed_[pose]; }

    /// Returns the front and rear angle of a pose, the means of both sides.
    static std::array<double, 2> anglesOf(const StandingPose& pose, const FloorParameters& x)
    {
        std::array<double, kFlippers> angle{};
        for (std::size_t f = 0; f < kFlippers; ++f)
            angle[f] = pose.mean.*kAngles[f] - x[static_cast<Eigen::Index>(P::Encoders + f)];
        return {0.5 * (angle[0] + angle[1]), 0.5 * (angle[2] + angle[3])};
    }
    static std::optional<FloorRest> restOf(const RobotModel& robot, const StandingPose& pose,
                                           const FloorParameters& x)
    {
        const auto [front, rear] = anglesOf(pose, x);
        return restOnFloor(robot, front, rear);
    }

    static bool isLoaded(const StandingPose& pose, std::size_t flipper)
    {
        return motorCurrents(pose.mean)[flipper].value_or(0.0) >= kLoadedCurrent;
    }

private:
    /// Returns 0 for pitch, 1 for roll, 2 for tips.
    static std::size_t kindOf(std::size_t residual) { return std::min<std::size_t>(residual, 2); }

    /// Returns the sd of the residuals of a kind over their expected sd, by their median; at least 1.
    double scatterOf(const FloorParameters& x, std::size_t kind) const
    {
        std::vector<double> all;
        all.reserve(4 * poses_.size());
        for (const StandingPose& pose : poses_)
            if (const auto r = residualsOf(pose, x))
                for (std::size_t k = 0; k < r->value.size(); ++k)
                    if (r->is[k] && kindOf(k) == kind) all.push_back(std::abs(r->value[k]));
        if (all.empty()) return 1.0;
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
        std::nth_element(all.begin(), middle, all.end());
        return std::max(1.0, 1.4826 * *middle);
    }

    std::optional<PoseResiduals> residualsOf(const StandingPose& pose,
                                             const FloorParameters& x) const
    {
        const RobotModel robot = withParameters(robot_, x);
        const auto rest = restOf(robot, pose, x);
        if (!rest) return {};
        PoseResiduals r;
        const auto set = [&r](std::size_t k, double value) { r.value[k] = value, r.is[k] = true; };
        const double play = rest->onFrontTip || rest->onRearTip ? 0.5 * kEncoderSd : 0.0;
        set(0, (pose.mean.pitch - rest->pitch - x[P::ImuPitch])
                   / std::hypot(pose.pitchSd, kModelSd, play));
        set(1, (pose.mean.roll - x[P::ImuRoll] + x[P::ImuYaw] * std::sin(rest->pitch))
                   / std::hypot(pose.rollSd, kModelSd));
        for (std::size_t f = 0; f < kFlippers; ++f) {
            if (!isLoaded(pose, f)) continue;
            const FlipperGeometry& flipper = f < 2 ? robot.front : robot.rear;
            const double angle =
                pose.mean.*kAngles[f] - x[static_cast<Eigen::Index>(P::Encoders + f)];
            set(2 + f, tipAboveFloor(*rest, flipper, angle) / (flipper.axleDistance * kEncoderSd));
        }
        return r;
    }

    /// Returns half of the sum of squares, of which large residuals count less.
    double costOf(const FloorParameters& x) const
    {
        double cost = 0.5 * (x - prior_).cwiseQuotient(priorSd()).squaredNorm();
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            if (!isUsed_[i]) continue;
            const auto r = residualsOf(poses_[i], x);
            if (!r) {
                cost += 100.0;
                continue;
            }
            for (std::size_t k = 0; k < r->value.size(); ++k)
                if (r->is[k]) cost += huber(std::abs(r->value[k]));
        }
        return cost;
    }
    static double huber(double r)
    {
        constexpr double kKnee = 3.0;
        return r < kKnee ? 0.5 * r * r : kKnee * (r - 0.5 * kKnee);
    }

    void normalEquations(const FloorParameters& x, Square& A, FloorParameters& b) const
    {
        const FloorParameters weight = priorSd().cwiseAbs2().cwiseInverse();
        A = weight.asDiagonal();
        b = weight.cwiseProduct(x - prior_);
        for (std::size_t i = 0; i < poses_.size(); ++i)
            if (isUsed_[i]) addPose(poses_[i], x, A, b);
    }

    void addPose(const StandingPose& pose, const FloorParameters& x, Square& A,
                 FloorParameters& b) const
    {
        constexpr double kStep = 1e-5;
        const auto at = residualsOf(pose, x);
        if (!at) return;
        std::array<FloorParameters, 6> slope{};
        slope.fill(FloorParameters::Zero());
        for (Eigen::Index p = 0; p < static_cast<Eigen::Index>(P::Count); ++p) {
            FloorParameters up = x, down = x;
            up[p] += kStep;
            down[p] -= kStep;
            const auto above = residualsOf(pose, up), below = residualsOf(pose, down);
            if (!above || !below) continue;
            for (std::size_t k = 0; k < slope.size(); ++k)
                slope[k][p] = (above->value[k] - below->value[k]) / (2.0 * kStep);
        }
        for (std::size_t k = 0; k < slope.size(); ++k) {
            if (!at->is[k]) continue;
            const double r = at->value[k], weight = std::abs(r) > 3.0 ? 3.0 / std::abs(r) : 1.0;
            A += weight * slope[k] * slope[k].transpose();
            b += weight * r * slope[k];
        }
    }

    const RobotModel& robot_;
    const std::vector<StandingPose>& poses_;
    FloorParameters prior_;
    std::vector<bool> isUsed_;
};

/// Fits the motors' torque where flipper tips carry the robot: torque of both motors = value · sum of their currents.
class TorqueFit {
public:
    void add(double torque, double left, double right)
    {
        if (torque <= 0.0) return;
        xy_ += torque * (left + right);
        xx_ += (left + right) * (left + right);
        yy_ += torque * torque;
        ++n_;
    }
    std::optional<Calibrated> result() const
    {
        if (n_ < 3 || xx_ <= 0.0) return {};
        const double slope = xy_ / xx_;
        const double scatter = std::max(0.0, yy_ - slope * xy_) / static_cast<double>(n_ - 1);
        return Calibrated{slope, std::sqrt(scatter / xx_), slope > 0.0};
    }

private:
    double xy_ = 0.0, xx_ = 0.0, yy_ = 0.0;
    std::size_t n_ = 0;
};

double rmsOfPitch(const RobotModel& robot, const std::vector<StandingPose>& poses,
                  const FloorFit& fit, const FloorParameters& x)
{
    double sum = 0.0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const auto rest = FloorFit::restOf(withParameters(robot, x), poses[i], x);
        if (!rest || !fit.isUsed(i)) continue;
        const double off = poses[i].mean.pitch - rest->pitch - x[P::ImuPitch];
        sum += off * off;
        ++n;
    }
    return n == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(n));
}

/// Which axles lift the robot in a pose, and how it rests.
struct Lift {
    FloorRest rest;
    bool front = false, rear = false;
};

/// Returns empty for a pose without rest. An axle lifts if the robot would pitch by 0.03 rad less without it. Flippers
/// that only lie on the floor do not count, because their load is unknown.
std::optional<Lift> liftOf(const RobotModel& robot, const StandingPose& pose,
                           const FloorParameters& x)
{
    constexpr double kLift = 0.03, kRaised = 1.2;  // [rad]
    const auto [front, rear] = FloorFit::anglesOf(pose, x);
    const auto rest = restOnFloor(robot, front, rear);
    if (!rest) return {};
    const auto turnsWithout = [&](double f, double r) {
        const auto other = restOnFloor(robot, f, r);
        return other && std::abs(other->pitch - rest->pitch) > kLift;
    };
    return Lift{*rest, rest->onFrontTip && turnsWithout(kRaised, rear),
                rest->onRearTip && turnsWithout(front, kRaised)};
}

/// Counts postures into `result`, and fits the torque at these parameters.
void judgePoses(RobotCalibration& result, const RobotModel& robot,
                const std::vector<StandingPose>& poses, const FloorFit& fit,
                const FloorParameters& x)
{
    TorqueFit torque;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const StandingPose& pose = poses[i];
        const auto lift = liftOf(withParameters(robot, x), pose, x);
        if (!lift || !fit.isUsed(i)) continue;
        const auto isLoaded = [&](std::size_t a, std::size_t b) {
            return FloorFit::isLoaded(pose, a) && FloorFit::isLoaded(pose, b);
        };
        result.onFrontTips += lift->front ? 1 : 0;
        result.onRearTips += lift->rear ? 1 : 0;
        if (lift->front && isLoaded(0, 1))
            torque.add(lift->rest.frontTorque, pose.mean.frontLeftCurrent,
                       pose.mean.frontRightCurrent);
        if (lift->rear && isLoaded(2, 3))
            torque.add(lift->rest.rearTorque, pose.mean.rearLeftCurrent,
                       pose.mean.rearRightCurrent);
    }
    result.torquePerAmpere = torque.result();
}

/// Adds what the geometry leaves open to the sd of the torque.
void addGeometry(RobotCalibration& result, const RobotModel& robot,
                 const std::vector<StandingPose>& poses, const FloorFit& fit,
                 const FloorParameters& x, const Square& covariance)
{
    constexpr double kStep = 1e-4;
    if (!result.torquePerAmpere) return;
    FloorParameters slope = FloorParameters::Zero();
    for (Eigen::Index p = 0; p < static_cast<Eigen::Index>(P::Count); ++p) {
        FloorParameters moved = x;
        moved[p] += kStep;
        RobotCalibration other;
        judgePoses(other, robot, poses, fit, moved);
        if (other.torquePerAmpere)
            slope[p] = (other.torquePerAmpere->value - result.torquePerAmpere->value) / kStep;
    }
    double& sd = result.torquePerAmpere->sd;
    sd = std::hypot(sd, std::sqrt(slope.dot(covariance * slope)));
    result.torquePerAmpere->isIdentified = sd < kMaxTorqueSd * result.torquePerAmpere->value;
}

}  // namespace

Result<RobotCalibration> calibrateRobot(const RobotModel& robot,
                                        const std::vector<StandingPose>& poses)
{
    if (poses.size() < kMinPoses)
        return Error{
            fmt::format("{} poses in which the robot stands still for 0.5 s, expected at "
                        "least {}: record a flat floor, and let the robot rest in each pose",
                        poses.size(), kMinPoses)};
    FloorFit fit(robot, poses);
    FloorParameters x = fit.best();
    for (int i = 0; i < 5 && fit.leaveOut(x); ++i) fit.descend(x);
    constexpr double kMaxRms = 0.03;  // [rad]
    if (2 * fit.used() < poses.size() || rmsOfPitch(robot, poses, fit, x) > kMaxRms)
        return Error{
            fmt::format("{} standing poses do not agree with a flat, level floor: record one, "
                        "or check signs and units of pitch and flipper angles first",
                        poses.size())};
    RobotCalibration result;
    result.poses = poses.size();
    result.used = fit.used();
    const Square covariance = fit.covariance(x);
    const FloorParameters before = priorSd();
    for (std::size_t p = 0; p < P::Count; ++p) {
        const auto i = static_cast<Eigen::Index>(p);
        const double sd = std::sqrt(covariance(i, i));
        result.parameter[p] = {x[i], sd, sd < 0.5 * before[i]};
    }
    result.before = rmsOfPitch(robot, poses, fit, parametersOf(robot));
    result.after = rmsOfPitch(robot, poses, fit, x);
    judgePoses(result, robot, poses, fit, x);
    addGeometry(result, robot, poses, fit, x, covariance);
    return result;
}

}  // namespace terratact
