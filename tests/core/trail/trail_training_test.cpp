#include "core/trail/trail_training.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/learn/data/drive_lines.h"
#include "core/trail/trail_inputs.h"
#include "core/trail/trail_model.h"
#include "tests/support/absolem.h"
#include "tests/support/small_trail.h"

namespace terratact {
namespace {

/// Returns eleven drives, and each of them twice more with heights that are 0.3 m too high, with this sd.
std::vector<DriveLines> spoiltDrives(std::optional<double> sd)
{
    std::vector<DriveLines> drives;
    drives.reserve(33);
    for (std::uint64_t k = 0; k < 11; ++k) drives.push_back(driveOnPlane(k));
    for (std::size_t k = 0; k < 22; ++k) {
        drives.push_back(drives[k % 11]);
        for (DriveLine& line : drives.back().lines)
            for (std::size_t side = 0; line.isScene && side < 2; ++side)
                for (std::size_t bin = 0; bin < kBins; ++bin) {
                    *line.truth.at(side)[bin] += 0.3;
                    line.truthSd.at(side)[bin] = sd;
                }
    }
    return drives;
}

/// Returns the mean error of networks on the farthest bin of one of their drives [m].
double biasOf(const std::vector<DriveLines>& drives)
{
    const TrailNetworks networks =
        trainTrail(trailRows(drives, 0, absolem(), false, 1), false, quickTrailOptions());
    const DriveLines judged = driveOnPlane(1);
    const TrailRows rows = trailRows({&judged, 1}, 1, absolem(), false, 1);
    constexpr Eigen::Index kFarthest = kBins - 1;
    const TrailScale& scale = networks.open[kFarthest];
    double sum = 0.0;
    for (Eigen::Index u = 0; u < rows.inputs.cols(); ++u) {
        const double output = static_cast<double>(
            outputOf(networks, rows.inputs.col(u).cast<double>()).mean[kFarthest]);
        sum += scale.mean + scale.sd * output - rows.heights(kFarthest, u);
    }
    return sum / static_cast<double>(rows.inputs.cols());
}

TEST(TrailTraining, HeightsOfALargeSdCountLess)
{
    EXPECT_EQ(trailWeight(0.0), 1.0);
    EXPECT_DOUBLE_EQ(trailWeight(kTrailSpread), 0.5);
    const double asExact = biasOf(spoiltDrives(std::nullopt));
    const double asDoubtful = biasOf(spoiltDrives(0.3));
    EXPECT_GT(asExact, 0.15);
    EXPECT_LT(std::abs(asDoubtful), 0.3 * asExact);
}

TEST(TrailTraining, UnknownHeightsLeaveTheOtherBins)
{
    DriveLines drive = driveOnPlane(1);
    DriveLine& scene = *std::ranges::find(drive.lines, true, &DriveLine::isScene);
    scene.truth[0][4].reset();
    scene.truth[1][4].reset();
    const TrailRows rows = trailRows({&drive, 1}, 1, absolem(), false, 1);
    EXPECT_EQ(rows.weights(4, 0), 0.0F);
    EXPECT_EQ(rows.weights(5, 0), 1.0F);
    for (auto& side : scene.truth) side.fill(std::nullopt);
    const TrailRows fewer = trailRows({&drive, 1}, 1, absolem(), false, 1);
    EXPECT_EQ(fewer.inputs.cols(), rows.inputs.cols() - 1);
    EXPECT_EQ(fewer.leftOut, rows.leftOut + 1);
}

TEST(TrailTraining, ErrorsNeedCompleteScenes)
{
    std::vector<DriveLines> drives = spoiltDrives(0.01);
    for (const std::size_t held : {0U, 10U, 20U, 30U})
        for (DriveLine& line : drives[held].lines)
            for (auto& side : line.truth) side[2].reset();
    try {
        (void)trainTrail(trailRows(drives, 0, absolem(), false, 1), false, quickTrailOptions());
        FAIL() << "no scene gives errors";
    } catch (const std::invalid_argument& refused) {
        EXPECT_NE(std::string(refused.what()).find("tenth drive"), std::string::npos);
    }
}

/// Returns rows of open bins whose heights are noise: of 0.06 m where the first input is positive, else of 0.02 m.
TrailRows noisyRows(int drives)
{
    constexpr int kScenes = 30;
    const Eigen::Index n = Eigen::Index{drives} * kScenes;
    std::mt19937_64 rng(3);
    std::normal_distribution<double> normal;
    TrailRows rows;
    rows.inputs.resize(kPlaneInputs, n);
    rows.heights.resize(kBins, n);
    rows.weights = Eigen::MatrixXf::Ones(kBins, n);
    rows.ceilings.setConstant(kBins, n, std::numeric_limits<double>::infinity());
    rows.covered.assign(static_cast<std::size_t>(n), 0U);
    for (Eigen::Index u = 0; u < n; ++u) {
        for (float& input : rows.inputs.col(u)) input = static_cast<float>(normal(rng));
        const double sd = rows.inputs(0, u) > 0.0F ? 0.06 : 0.02;
        for (double& height : rows.heights.col(u)) height = sd * normal(rng);
        rows.drive.push_back(static_cast<int>(u) / kScenes);
    }
    return rows;
}

TEST(TrailTraining, LearnsWhereErrorsAreLarge)
{
    TrailOptions options = quickTrailOptions();
    options.network.epochs = 2;
    const TrailRows rows = noisyRows(400);
    const TrailNetworks networks = trainTrail(rows, false, options);
    Eigen::VectorXd inputs = Eigen::VectorXd::Zero(kPlaneInputs);
    const auto sizeAt = [&](double first) {
        inputs[0] = first;
        return errorSize(networks, outputOf(networks, inputs)).mean();
    };
    EXPECT_GT(sizeAt(1.5), 2.0F * sizeAt(-1.5));
    std::array<double, 2> squares{},
        counts{};  // of errors in their expected size, which leaves no difference
    Eigen::Index k = 0;
    for (std::size_t u = 0; u < rows.drive.size(); ++u) {
        if (rows.drive[u] % kErrorDrives != 0) continue;
        const std::size_t isLarge = rows.inputs(0, static_cast<Eigen::Index>(u)) > 0.0F ? 1 : 0;
        squares.at(isLarge) += static_cast<double>(networks.errors.residual.col(k++).squaredNorm());
        counts.at(isLarge) += 1.0;
    }
    EXPECT_EQ(k, networks.errors.residual.cols());
    const double ratio = std::sqrt(squares[1] / counts[1] / (squares[0] / counts[0]));
    EXPECT_GT(ratio, 0.6);
    EXPECT_LT(ratio, 1.7);
}

TEST(TrailModel, SameDrivesAndSeedLearnTheSame)
{
    std::vector<DriveLines> drives;
    drives.reserve(12);
    for (std::uint64_t k = 0; k < 12; ++k) drives.push_back(driveOnPlane(k));
    const TrailRows rows = trailRows(drives, 0, absolem(), false, 1);
    const TrailRows parts[] = {trailRows({drives.data(), 5}, 0, absolem(), false, 1),
                               trailRows({drives.data() + 5, 7}, 5, absolem(), false, 1)};
    EXPECT_EQ(rows.inputs, joined(parts).inputs);
    EXPECT_EQ(rows.drive, joined(parts).drive);
    TrailOptions options = quickTrailOptions();
    options.network.epochs = 2;
    const ForEach backwards = [](int count, const std::function<void(int)>& work) {
        for (int k = count - 1; k >= 0; --k) work(k);
    };
    const TrailNetworks a = trainTrail(rows, false, options);
    const TrailNetworks b = trainTrail(rows, false, options, backwards);
    EXPECT_EQ(a.networks[1].layers[0].weight, b.networks[1].layers[0].weight);
    EXPECT_EQ(a.errors.residual, b.errors.residual);
    EXPECT_THROW(trainTrail(TrailRows{}, false, options), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
