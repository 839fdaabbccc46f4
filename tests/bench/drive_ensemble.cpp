#include "tests/bench/drive_ensemble.h"

#include <algorithm>
#include <cmath>

#include "core/infer/estimate/quantile.h"
#include "core/robot/kinematics.h"
#include "core/sim/drive.h"
#include "core/sim/ground/random_draw.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/rest/rest_pose.h"
#include "core/sim/sensor_noise.h"
#include "core/terrain/body_ceiling.h"
#include "core/terrain/terrain_profile.h"
#include "tests/bench/ensemble_update.h"

namespace terratact {
namespace {

constexpr double kPost = 0.05;         // [m]
constexpr double kBehindStart = 1.0;   // [m] of ground behind the robot at the start
constexpr double kAheadOfEnd = 1.5;    // [m] of ground ahead of the way's end
constexpr double kUpdateEvery = 0.12;  // [m] of way without a press

/// Coarser than the ground of simulated drives, for less computing.
constexpr GroundOptions kCoarse{.spacing = 0.01, .settled = 1e-9};

PressReadings readingsOf(const Proprioception& s)
{
    PressReadings r{s.pitch, s.frontCurrent.value(), s.rearCurrent.value(), s.front};
    for (std::size_t e = 0; e < kForceElements; ++e) r.at(4 + e) = s.force.at(e).value();
    return r;
}

/// Returns the sd of readings: that of the sensors and that of the ground's representation.
Eigen::VectorXd sdOf(const PressReadings& measured, const PressReadings& ofGround)
{
    const SensorNoise noise;
    PressReadings sd{noise.pitch, noise.current, noise.current, noise.flipperAngle};
    for (std::size_t k = 4; k < kPressReadings; ++k)
        sd.at(k) = std::hypot(noise.forceShare * measured.at(k), noise.forceFloor);
    for (std::size_t k = 0; k < kPressReadings; ++k)
        sd.at(k) = std::hypot(sd.at(k), ofGround.at(k));
    return Eigen::Map<const Eigen::VectorXd>(sd.data(), kPressReadings);
}

/// Returns the rises from post to post of a random piece of generated ground. It goes on with
/// further grounds.
Eigen::VectorXd randomRises(Eigen::Index count, std::mt19937_64& rng)
{
    TerrainProfile ground = randomVariedTerrain(rng);
    double x = uniform(rng, ground.begin(), ground.end());
    Eigen::VectorXd rises(count);
    for (double& rise : rises) {
        if (x + kPost > ground.end()) {
            ground = randomVariedTerrain(rng);
            x = ground.begin();
        }
        rise = ground.heightAt(x + kPost) - ground.heightAt(x);
        x += kPost;
    }
    return rises;
}

TerrainProfile groundOf(const Eigen::Ref<const Eigen::VectorXd>& rises)
{
    std::vector<double> heights{0.0};
    for (const double rise : rises) heights.push_back(heights.back() + rise);
    return TerrainProfile::fromSamples(heights, kPost, false);
}

/// Returns the ground through posts from x = 0 on.
TerrainProfile throughPosts(const TerrainProfile& ground)
{
    std::vector<double> heights;
    for (double x = 0.0; x < ground.end(); x += kPost) heights.push_back(ground.heightAt(x));
    return TerrainProfile::fromSamples(heights, kPost, false);
}

/// Returns the readings at a press on the ground; empty: no rest pose.
std::optional<PressReadings> pressedOn(const RobotModel& robot, const TerrainProfile& ground,
                                       double x, const DriveStyle& style,
                                       const GroundOptions& options)
{
    const auto rest = restPose(robot, ground, x, PressTorque{style.pressTorque},
                               HoldAngle{style.rearAngle}, 0.0, options);
    if (!rest) return std::nullopt;
    return readingsOf(exactReadings(robot, *rest));
}

/// Returns height, q10 and q90 of bins; heights: one column per member.
TerrainEstimate estimateOf(const Eigen::MatrixXd& heights, const Heights& ceiling)
{
    TerrainEstimate estimate;
    for (std::size_t i = 0; i < kBins; ++i) {
        const auto row = heights.row(static_cast<Eigen::Index>(i));
        const Eigen::VectorXd below = row.transpose().cwiseMin(ceiling.at(i));
        std::vector<double> draws(below.begin(), below.end());
        std::ranges::sort(draws);
        estimate.height.at(i) = quantileOfSorted(draws, 0.5);
        estimate.q10.at(i) = quantileOfSorted(draws, 0.1);
        estimate.q90.at(i) = quantileOfSorted(draws, 0.9);
    }
    return estimate;
}

}  // namespace

PressReadings postsSd(const RobotModel& robot, std::uint64_t seed)
{
    constexpr int kPoses = 200;
    constexpr double kMargin = 1.0;  // [m]
    std::mt19937_64 rng(seed);
    std::array<std::vector<double>, kPressReadings> differences;
    for (int pose = 0; pose < kPoses; ++pose) {
        const TerrainProfile ground = randomVariedTerrain(rng);
        const DriveStyle style = randomDriveStyle(rng);
        const double x = uniform(rng, kMargin, ground.end() - kMargin);
        const auto exact = pressedOn(robot, ground, x, style, {});
        const auto coarse = pressedOn(robot, throughPosts(ground), x, style, kCoarse);
        if (!exact || !coarse) continue;
        for (std::size_t k = 0; k < kPressReadings; ++k)
            differences.at(k).push_back(coarse->at(k) - exact->at(k));
    }
    PressReadings sd{};
    for (std::size_t k = 0; k < kPressReadings; ++k)
        sd.at(k) = 0.5 * (quantile(differences.at(k), 0.84) - quantile(differences.at(k), 0.16));
    return sd;
}

DriveEnsemble::DriveEnsemble(const RobotModel& robot, const EnsembleOptions& options, double way,
                             std::seed_seq& seed)
    : robot_(robot), options_(options), rng_(seed)
{
    const auto rises =
        static_cast<Eigen::Index>(std::ceil((kBehindStart + way + kAheadOfEnd) / kPost));
    rises_.resize(rises, options.members);
    for (Eigen::Index m = 0; m < members(); ++m) rises_.col(m) = randomRises(rises, rng_);
    x_ = Eigen::RowVectorXd::Constant(members(), kBehindStart);
    slip_.resize(members());
    drawSlip();
}

void DriveEnsemble::drawSlip()
{
    std::normal_distribution<double> standard;
    for (double& slip : slip_) slip = robot_.travelledSdShare * standard(rng_);
}

void DriveEnsemble::moveTo(const Measurement& line)
{
    const OdometryLine now = odometryOf(line);
    if (!odometry_) odometry_.emplace(robot_, now);
    const double before = odometry_->now().rolled.x;
    odometry_->add(now);
    const double step = odometry_->now().rolled.x - before;
    x_.array() += step / (1.0 + slip_.array());
    since_ += std::abs(step);
}

void DriveEnsemble::drive(const Measurement& line)
{
    moveTo(line);
    if (since_ < kUpdateEvery) return;
    const Proprioception s = proprioception(line);
    learn(s, HoldAngle{s.front}, kWayReadings);
}

std::optional<TerrainEstimate> DriveEnsemble::press(const Measurement& scene)
{
    moveTo(scene);
    const Proprioception s = proprioception(scene);
    currents_.push_back(s.frontCurrent.value());
    const auto bins = learn(s, PressTorque{pressTorque()}, kPressReadings);
    drawSlip();
    if (!bins) return std::nullopt;
    return estimateOf(*bins, bodyCeiling(robot_, s.pitch, s.front, s.rear));
}

/// Returns the torque of both front flippers [N m], within the range of randomDriveStyle().
double DriveEnsemble::pressTorque() const
{
    constexpr double kLeast = 12.0, kMost = 24.0;
    return std::clamp(2.0 * robot_.torquePerAmpere * quantile(currents_, 0.5), kLeast, kMost);
}

DriveEnsemble::Predictions DriveEnsemble::predictions(const Proprioception& s,
                                                      const FlipperDrive& front) const
{
    Predictions predicted{.readings = Eigen::MatrixXd(kPressReadings, members()),
                          .bins = Eigen::MatrixXd(kBins, members()),
                          .standing = {},
                          .fallen = {}};
    for (Eigen::Index m = 0; m < members(); ++m) {
        const TerrainProfile ground = groundOf(rises_.col(m));
        const auto rest =
            restPose(robot_, ground, x_[m], front, HoldAngle{s.rear}, s.pitch, kCoarse);
        (rest ? predicted.standing : predicted.fallen).push_back(m);
        if (!rest) continue;
        const PressReadings readings = readingsOf(exactReadings(robot_, *rest));
        const Heights heights = binHeights(ground, imuPosition(robot_, rest->pose));
        predicted.readings.col(m) =
            Eigen::Map<const Eigen::VectorXd>(readings.data(), kPressReadings);
        predicted.bins.col(m) = Eigen::Map<const Eigen::VectorXd>(heights.data(), kBins);
    }
    return predicted;
}

void DriveEnsemble::replaceFallen(Predictions& predicted)
{
    const std::vector<Eigen::Index>& standing = predicted.standing;
    for (const Eigen::Index m : predicted.fallen) {
        const Eigen::Index from = standing.at(rng_() % standing.size());
        rises_.col(m) = rises_.col(from);
        x_[m] = x_[from];
        slip_[m] = slip_[from];
        predicted.readings.col(m) = predicted.readings.col(from);
        predicted.bins.col(m) = predicted.bins.col(from);
    }
}

/// Updates the ensemble by the first `readings` of s. Returns the heights of the bins after that;
/// empty, without an update: no member has a rest pose.
std::optional<Eigen::MatrixXd> DriveEnsemble::learn(const Proprioception& s,
                                                    const FlipperDrive& front, std::size_t readings)
{
    since_ = 0.0;
    Predictions predicted = predictions(s, front);
    if (predicted.standing.empty()) return std::nullopt;
    replaceFallen(predicted);
    return update(predicted, readingsOf(s), readings);
}

Eigen::MatrixXd DriveEnsemble::update(const Predictions& predicted, const PressReadings& measured,
                                      std::size_t readings)
{
    const auto used = static_cast<Eigen::Index>(readings);
    Eigen::MatrixXd state(rises_.rows() + 1 + kBins, members());
    state << rises_, x_, predicted.bins;
    const EnsembleReadings seen{.predicted = predicted.readings.topRows(used),
                                .measured =
                                    Eigen::Map<const Eigen::VectorXd>(measured.data(), used),
                                .sd = sdOf(measured, options_.groundSd).head(used)};
    updateEnsemble(state, seen, taper(state.rows()), options_.relaxation, rng_);
    rises_ = state.topRows(rises_.rows());
    x_ = state.row(rises_.rows());
    return state.bottomRows(kBins);
}

/// Returns the taper of each row: rises by their distance from the robot, place and bins 1.
Eigen::VectorXd DriveEnsemble::taper(Eigen::Index rows) const
{
    Eigen::VectorXd result = Eigen::VectorXd::Ones(rows);
    const double x = x_.mean();
    for (Eigen::Index k = 0; k < rises_.rows(); ++k)
        result[k] = taperAt((static_cast<double>(k) + 0.5) * kPost - x, options_.reach);
    return result;
}

}  // namespace terratact
