#include "core/trail/trail_training.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <utility>

#include "core/base/random_unit.h"
#include "core/learn/data/scene.h"
#include "core/learn/data/side_features.h"
#include "core/learn/model/clearance.h"
#include "core/learn/model/surface_rows.h"
#include "core/terrain/body_ceiling.h"
#include "core/trail/trail_file.h"
#include "core/trail/trail_inputs.h"
#include "core/trail/trail_record.h"

namespace terratact {
namespace {

constexpr Eigen::Index kTrailSides = 2;
constexpr double kMinTrailSd = 1e-6;
constexpr double kMinRegimeScenes = 30.0;  // of a regime that counts as trained

// The expected size of an error is fitted to |error| + kMinTrailError, in sd of TrailScale. The ridge has the weight of
// kSizeRidge scenes with inputs of sd 1 and no effect.
constexpr float kMinTrailError = 0.1F;
constexpr double kSizeRidge = 30.0;

/// Returns true if a scene has everything that a row needs.
bool isUsable(const DriveLine& scene, bool sides)
{
    if (!knowsHeights(scene.truth[0]) && !knowsHeights(scene.truth[1])) return false;
    if (!sides) return missingFeatures(proprioception(scene.line)).none();
    return absentFeatures(twoTrackReadings(scene.line), Side::Left).none();
}

/// One column of the rows.
struct TrailRow {
    Eigen::VectorXd inputs;
    Heights ceiling{};
    OptionalHeights truth{}, truthSd{};
};

TrailRow planeRow(const DriveLine& scene, const TrailHistory& history, const RobotModel& robot)
{
    const Proprioception s = proprioception(scene.line);
    const Heights ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);
    return {planeInputs(s, history, ceiling), ceiling, scene.truth[0], scene.truthSd[0]};
}

TrailRow sideRow(const DriveLine& scene, Side side, const TrailHistory& history,
                 const RobotModel& robot)
{
    const TwoTrackReadings s = twoTrackReadings(scene.line);
    const Heights ceiling = sideCeiling(robot, s, side);
    const std::size_t k = side == Side::Left ? 0 : 1;
    return {sideInputs(s, side, history, ceiling), ceiling, scene.truth.at(k), scene.truthSd.at(k)};
}

bool isForErrors(int drive)
{
    return drive % kErrorDrives == 0;
}

std::vector<TrailRow> rowsOfDrive(const DriveLines& drive, bool cuts, const RobotModel& robot,
                                  bool sides, std::mt19937_64& rng, int& leftOut)
{
    std::vector<TrailRow> rows;
    TrailRecord record(robot);
    for (const DriveLine& line : drive.lines) {
        if (!line.isScene) {
            record.add(line.line);
            continue;
        }
        const double chance = randomUnit(rng), part = randomUnit(rng);
        const double way = cuts && chance < kCutShare ? part * kTrailReach : kTrailReach;
        if (isUsable(line, sides)) {
            const TrailHistory history = record.before(line.line, way);
            if (sides) {
                rows.push_back(sideRow(line, Side::Left, history, robot));
                rows.push_back(sideRow(line, Side::Right, history, robot));
            } else {
                rows.push_back(planeRow(line, history, robot));
            }
        } else {
            ++leftOut;
        }
        record.addScene(line.line);
    }
    return rows;
}

TrailRows asColumns(const std::vector<TrailRow>& rows, Eigen::Index inputs)
{
    const Eigen::Index n = std::ssize(rows);
    TrailRows all;
    all.inputs.resize(inputs, n);
    all.heights = Eigen::MatrixXd::Zero(kBins, n);
    all.weights = Eigen::MatrixXf::Zero(kBins, n);
    all.ceilings.resize(kBins, n);
    all.covered.reserve(rows.size());
    for (Eigen::Index u = 0; u < n; ++u) {
        const TrailRow& row = rows[static_cast<std::size_t>(u)];
        all.inputs.col(u) = row.inputs.cast<float>();
        for (Eigen::Index i = 0; i < kBins; ++i) {
            const auto bin = static_cast<std::size_t>(i);
            all.ceilings(i, u) = row.ceiling[bin];
            if (!row.truth[bin]) continue;
            all.heights(i, u) = *row.truth[bin];
            all.weights(i, u) = static_cast<float>(trailWeight(row.truthSd[bin].value_or(0.0)));
        }
        all.covered.push_back(coveredBins(row.ceiling));
    }
    return all;
}

std::vector<Eigen::Index> columnsWhere(const TrailRows& rows, bool forErrors)
{
    std::vector<Eigen::Index> columns;
    for (std::size_t u = 0; u < rows.drive.size(); ++u)
        if (isForErrors(rows.drive[u]) == forErrors)
            columns.push_back(static_cast<Eigen::Index>(u));
    return columns;
}

void writeInputScale(TrailNetworks& networks, const Eigen::MatrixXf& inputs)
{
    const Eigen::MatrixXd values = inputs.cast<double>();
    networks.inputMean = values.rowwise().mean();
    const Eigen::MatrixXd centred = values.colwise() - networks.inputMean;
    networks.inputSd =
        (centred.rowwise().squaredNorm() / static_cast<double>(values.cols())).cwiseSqrt();
    // An input that never varied has no effect in training, and little elsewhere.
    networks.inputSd = (networks.inputSd.array() < kMinTrailSd).select(1.0, networks.inputSd);
}

double surfaceAt(const TrailRows& rows, Eigen::Index bin, Eigen::Index u)
{
    return toSurface(rows.heights(bin, u), rows.ceilings(bin, u));
}

TrailScale& scaleIn(TrailNetworks& networks, Eigen::Index bin, bool covered)
{
    auto& scales = covered ? networks.covered : networks.open;
    return scales[static_cast<std::size_t>(bin)];
}

void writeScales(TrailNetworks& networks, const TrailRows& rows,
                 const std::vector<Eigen::Index>& columns)
{
    for (Eigen::Index bin = 0; bin < kBins; ++bin)
        for (const bool covered : {false, true}) {
            double sum = 0.0, squares = 0.0, weights = 0.0, count = 0.0;
            for (const Eigen::Index u : columns) {
                if (isCovered(rows.covered[static_cast<std::size_t>(u)], static_cast<int>(bin))
                    != covered)
                    continue;
                const auto weight = static_cast<double>(rows.weights(bin, u));
                if (weight == 0.0) continue;
                const double y = surfaceAt(rows, bin, u);
                sum += weight * y;
                squares += weight * y * y;
                weights += weight;
                count += 1.0;
            }
            if (count < kMinRegimeScenes) continue;
            const double mean = sum / weights;
            scaleIn(networks, bin, covered) = {
                mean,
                std::max(std::sqrt(std::max(squares / weights - mean * mean, 0.0)), kMinTrailSd)};
        }
}

/// Returns the surface coordinates of a column, in sd of TrailScale. They are 0 in a regime without scale and for an
/// unknown height.
Eigen::VectorXf targetOf(TrailNetworks& networks, const TrailRows& rows, Eigen::Index u)
{
    Eigen::VectorXf target = Eigen::VectorXf::Zero(Eigen::Index{kBins});
    for (Eigen::Index bin = 0; bin < kBins; ++bin) {
        const TrailScale& scale =
            scaleIn(networks, bin,
                    isCovered(rows.covered[static_cast<std::size_t>(u)], static_cast<int>(bin)));
        if (scale.sd > 0.0 && rows.weights(bin, u) > 0.0F)
            target[bin] = static_cast<float>((surfaceAt(rows, bin, u) - scale.mean) / scale.sd);
    }
    return target;
}

/// Returns the values in steps of the file.
Eigen::VectorXf rounded(const Eigen::VectorXf& values)
{
    return values.unaryExpr([](float value) { return errorOfSteps(errorSteps(value)); });
}

/// Returns the columns of the scenes for the errors whose heights are all known.
std::vector<Eigen::Index> completeColumns(const TrailRows& rows, Eigen::Index sides)
{
    const std::vector<Eigen::Index> all = columnsWhere(rows, true);
    std::vector<Eigen::Index> columns;
    columns.reserve(all.size());
    for (std::size_t u = 0; u + static_cast<std::size_t>(sides) <= all.size();
         u += static_cast<std::size_t>(sides))
        if ((rows.weights.middleCols(all[u], sides).array() > 0.0F).all())
            for (Eigen::Index side = 0; side < sides; ++side) columns.push_back(all[u] + side);
    return columns;
}

/// Returns the linear layer with the least squared error and a ridge on the weights of standardised inputs. One column
/// per example.
NetworkLayer ridgeLayer(const Eigen::MatrixXd& inputs, const Eigen::MatrixXd& targets)
{
    const auto count = static_cast<double>(inputs.cols());
    const Eigen::VectorXd mean = inputs.rowwise().mean(), middle = targets.rowwise().mean();
    const Eigen::MatrixXd centred = inputs.colwise() - mean;
    const Eigen::VectorXd sd =
        (centred.rowwise().squaredNorm() / count).cwiseSqrt().cwiseMax(kMinTrailSd);
    const Eigen::MatrixXd z = sd.cwiseInverse().asDiagonal() * centred;
    Eigen::MatrixXd normal = z * z.transpose();
    normal.diagonal().array() += kSizeRidge;
    const Eigen::MatrixXd product = z * (targets.colwise() - middle).transpose();
    const Eigen::MatrixXd weight =
        normal.llt().solve(product).transpose() * sd.cwiseInverse().asDiagonal();
    return {weight.cast<float>(), (middle - weight * mean).cast<float>()};
}

/// Learns the expected size of errors from them, and divides them by it. outputs: of each side of each scene.
void writeSize(TrailNetworks& networks, const std::vector<TrailOutput>& outputs)
{
    Eigen::MatrixXf& residual = networks.errors.residual;
    const Eigen::Index columns = std::ssize(outputs), sides = residual.rows() / kBins;
    Eigen::MatrixXd inputs(outputs.front().sizeInputs.size(), columns);
    for (Eigen::Index u = 0; u < columns; ++u)
        inputs.col(u) = outputs[static_cast<std::size_t>(u)].sizeInputs.cast<double>();
    const Eigen::Map<const Eigen::MatrixXf> bySide(residual.data(), kBins, columns);
    const Eigen::MatrixXd targets = (bySide.array().abs() + kMinTrailError).log().cast<double>();
    networks.size.layers = {ridgeLayer(inputs, targets)};
    for (Eigen::Index u = 0; u < columns; ++u) {
        auto own = residual.block(u % sides * kBins, u / sides, kBins, 1);
        own = rounded(own.cwiseQuotient(errorSize(networks, outputs[static_cast<std::size_t>(u)])));
    }
}

void writeErrors(TrailNetworks& networks, const TrailRows& rows, Eigen::Index sides)
{
    const std::vector<Eigen::Index> columns = completeColumns(rows, sides);
    const Eigen::Index scenes =
        std::min<Eigen::Index>(std::ssize(columns) / sides, kMaxTrailErrors);
    if (scenes == 0)
        throw std::invalid_argument(
            "trail networks: no scene of every tenth drive, from the first, knows all heights, and "
            "these give the bands: map the places better, or add drives");
    TrailErrors& errors = networks.errors;
    errors.predicted.resize(sides * kBins, scenes);
    errors.residual.resize(sides * kBins, scenes);
    std::vector<TrailOutput> outputs;
    outputs.reserve(static_cast<std::size_t>(scenes * sides));
    for (Eigen::Index k = 0; k < scenes; ++k) {
        std::array<unsigned, 2> covered{};
        for (Eigen::Index side = 0; side < sides; ++side) {
            const Eigen::Index u = columns[static_cast<std::size_t>(sides * k + side)];
            outputs.push_back(outputOf(networks, rows.inputs.col(u).cast<double>()));
            const Eigen::VectorXf& predicted = outputs.back().mean;
            errors.predicted.block(side * kBins, k, kBins, 1) = rounded(predicted);
            errors.residual.block(side * kBins, k, kBins, 1) =
                targetOf(networks, rows, u) - predicted;
            covered[static_cast<std::size_t>(side)] = rows.covered[static_cast<std::size_t>(u)];
        }
        if (sides == 1) covered[1] = covered[0];
        errors.covered.push_back(covered);
        errors.drive.push_back(
            rows.drive[static_cast<std::size_t>(columns[static_cast<std::size_t>(sides * k)])]);
    }
    writeSize(networks, outputs);
}

void inTurn(int count, const std::function<void(int)>& work)
{
    for (int k = 0; k < count; ++k) work(k);
}

}  // namespace

double trailWeight(double s)
{
    return kTrailSpread * kTrailSpread / (kTrailSpread * kTrailSpread + s * s);
}

TrailRows trailRows(std::span<const DriveLines> drives, int number, const RobotModel& robot,
                    bool sides, std::uint64_t seed, const Poll& poll)
{
    std::vector<TrailRows> parts;
    parts.reserve(drives.size());
    for (const DriveLines& drive : drives) {
        callPoll(poll);
        std::mt19937_64 rng(seed + static_cast<std::uint64_t>(number));
        int leftOut = 0;
        const std::vector<TrailRow> rows =
            rowsOfDrive(drive, !isForErrors(number), robot, sides, rng, leftOut);
        TrailRows own = asColumns(rows, sides ? kSideInputs : kPlaneInputs);
        own.drive.assign(rows.size(), number);
        own.leftOut = leftOut;
        parts.push_back(std::move(own));
        ++number;
    }
    return joined(parts);
}

TrailRows joined(std::span<const TrailRows> parts)
{
    Eigen::Index n = 0, inputs = 0;
    for (const TrailRows& part : parts) {
        n += part.inputs.cols();
        inputs = part.inputs.rows();
    }
    TrailRows all;
    all.inputs.resize(inputs, n);
    all.heights.resize(kBins, n);
    all.weights.resize(kBins, n);
    all.ceilings.resize(kBins, n);
    Eigen::Index first = 0;
    for (const TrailRows& part : parts) {
        const Eigen::Index count = part.inputs.cols();
        all.inputs.middleCols(first, count) = part.inputs;
        all.heights.middleCols(first, count) = part.heights;
        all.weights.middleCols(first, count) = part.weights;
        all.ceilings.middleCols(first, count) = part.ceilings;
        all.covered.insert(all.covered.end(), part.covered.begin(), part.covered.end());
        all.drive.insert(all.drive.end(), part.drive.begin(), part.drive.end());
        all.leftOut += part.leftOut;
        first += count;
    }
    return all;
}

TrailNetworks trainTrail(const TrailRows& rows, bool sides, const TrailOptions& options,
                         const ForEach& sideBySide, const Poll& poll)
{
    if (options.networks < 1) throw std::invalid_argument("trail networks: at least one");
    const std::vector<Eigen::Index> columns = columnsWhere(rows, false);
    if (std::ssize(columns) < options.network.batch)
        throw std::invalid_argument("trail networks: too few scenes to learn from");
    TrailNetworks networks;
    const Eigen::MatrixXf raw = rows.inputs(Eigen::all, columns);
    writeInputScale(networks, raw);
    writeScales(networks, rows, columns);
    const Eigen::MatrixXf inputs =
        (raw.colwise() - networks.inputMean.cast<float>()).array().colwise()
        / networks.inputSd.cast<float>().array();
    Eigen::MatrixXf targets(Eigen::Index{kBins}, inputs.cols());
    for (Eigen::Index u = 0; u < targets.cols(); ++u)
        targets.col(u) = targetOf(networks, rows, columns[static_cast<std::size_t>(u)]);
    const Eigen::MatrixXf weights = rows.weights(Eigen::all, columns);
    networks.networks.resize(static_cast<std::size_t>(options.networks));
    const auto train = [&](int k) {
        NetworkOptions own = options.network;
        own.seed += static_cast<std::uint64_t>(k);
        networks.networks[static_cast<std::size_t>(k)] =
            trainNetwork(inputs, targets, own, poll, weights);
    };
    if (sideBySide)
        sideBySide(options.networks, train);
    else
        inTurn(options.networks, train);
    writeErrors(networks, rows, sides ? kTrailSides : 1);
    requireTrailNetworks(networks, rows.inputs.rows(), sides ? kTrailSides : 1);
    return networks;
}

}  // namespace terratact
