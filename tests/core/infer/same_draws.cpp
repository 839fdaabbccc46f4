// Prints a hash of every bit of several results. These are truncated normal draws, an estimate's numbers, and whole
// estimates by local, joint and clearance. Also the sampler's states in single and double precision, and through few
// training rows.
// same_draws_test.py compares the output of builds by several compilers: its own builds, or those of the presets.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/infer/closed_form.h"
#include "core/infer/reconstruct_clearance.h"
#include "core/infer/sampling/draw_summary.h"
#include "core/infer/sampling/gibbs.h"
#include "core/infer/sampling/truncated_normal.h"
#include "core/learn/data/columns.h"
#include "core/learn/model/clearance_training.h"

namespace terratact {
namespace {

/// FNV-1a over the bytes of doubles.
class Hash {
public:
    void add(const double* values, std::size_t count)
    {
        for (std::size_t k = 0; k < count; ++k) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, values + k, sizeof bits);
            for (int shift = 0; shift < 64; shift += 8)
                value_ = (value_ ^ ((bits >> shift) & 0xffU)) * 1099511628211U;
        }
    }
    void add(const Heights& h) { add(h.data(), h.size()); }
    void add(const Eigen::MatrixXd& m) { add(m.data(), static_cast<std::size_t>(m.size())); }
    bool operator==(const Hash&) const = default;
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037U;
};

double uniform(std::mt19937_64& rng)
{
    return static_cast<double>(rng() >> 11U) * 0x1p-53;
}

Hash hashOfDraws()
{
    const double infinity = std::numeric_limits<double>::infinity();
    std::mt19937_64 rng(7);
    Hash hash;
    for (const double ceiling : {infinity, 3.0, 0.3, 0.0, -0.2, -2.0, -9.0, -38.0, -1e5, -1e9})
        for (const double width : {infinity, 6.0, 1.0, 1e-3})
            for (int k = 0; k < 2000; ++k) {
                const double floor = width < infinity ? std::min(ceiling, 5.0) - width : -infinity;
                const double h = drawBetween(floor, ceiling, 0.01, 0.7, rng);
                hash.add(&h, 1);
            }
    return hash;
}

/// Returns an artificial model of 300 rows on pitch and flipper angles.
ModelData someModel()
{
    constexpr int kRows = 300;
    std::mt19937_64 rng(1);
    ModelData model;
    model.scannedHeights.resize(kRows, kBins);
    model.features.resize(kRows, 3);
    for (double& x : model.features.reshaped()) x = uniform(rng) - 0.5;
    for (int u = 0; u < kRows; ++u)
        for (int i = 0; i < kBins; ++i)
            model.scannedHeights(u, i) = 0.1 * model.features(u, i % 3) - 0.3 + 0.05 * uniform(rng);
    model.heights = model.scannedHeights;
    model.pa.set = FeatureSet::Pa;
    model.pa.mean = Eigen::VectorXd::Constant(kBins + 3, -0.3);
    model.pa.mean.tail(3).setZero();
    model.pa.sd = Eigen::VectorXd::Constant(kBins + 3, 0.3);
    for (std::size_t i = 0; i < kBins; ++i)
        model.pa.bins[i] = {Eigen::VectorXd::Constant(kBins + 2, 1.5), 0.05, 0.02};
    return model;
}

struct Hashes {
    Hash states, inDouble, throughFewRows, estimate;
    bool operator==(const Hashes&) const = default;
};

GibbsProblem someProblem()
{
    GibbsProblem problem;
    problem.s = Eigen::Vector3d(0.1, -0.2, 0.3);
    problem.known[3] = -0.28;
    problem.ceiling.fill(-0.27);
    problem.scan = ScanOrder::Random;
    problem.chains = 8;
    problem.burnIn = 5;
    problem.keptPerChain = 60;
    return problem;
}

Hash hashOfStates(const BinModels& models, const GibbsProblem& problem)
{
    Hash hash;
    for (const Eigen::MatrixXd& bin : sampleHeights(models, problem).draws) hash.add(bin);
    return hash;
}

Hashes hashesOf(const BinModels& models)
{
    Hashes hashes;
    GibbsProblem other = someProblem();
    other.precision = Precision::Double;
    hashes.inDouble = hashOfStates(models, other);
    other = someProblem();
    other.inducing = 60;
    hashes.throughFewRows = hashOfStates(models, other);
    const GibbsDraws draws = sampleHeights(models, someProblem());
    TerrainEstimate estimate;
    for (std::size_t k = 0; k < draws.bins.size(); ++k) {
        hashes.states.add(draws.draws[k]);
        summariseDraws(estimate, draws.bins[k], draws.draws[k], Origin::Sampled, Centre::Median);
    }
    for (const Heights& h : {estimate.mean, estimate.sd, estimate.q10, estimate.q90,
                             estimate.height, estimate.rhat, estimate.ess})
        hashes.estimate.add(h);
    return hashes;
}

/// Computes the same scene in several threads that share the models.
Hashes hashesIn(int threads)
{
    const BinModels models(someModel(), FeatureSet::Pa);
    std::vector<Hashes> hashes(static_cast<std::size_t>(threads));
    {
        std::vector<std::jthread> pool;
        for (Hashes& own : hashes) pool.emplace_back([&] { own = hashesOf(models); });
    }
    for (const Hashes& h : hashes)
        if (!(h == hashes.front())) std::puts("threads of one program differ");
    return hashes.front();
}

/// Returns a robot with tracks and two flippers.
RobotModel someRobot()
{
    RobotModel robot;
    robot.baseHeight = 0.12;
    robot.trackAxle = 0.5;
    robot.trackRadius = 0.09;
    robot.trackZ = -0.03;
    robot.front = {{0.25, -0.03}, 0.09, 0.04, 0.35, 3.0, 0.15};
    robot.rear = {{-0.25, -0.03}, 0.09, 0.04, 0.35, 3.0, 0.15};
    robot.elementShare = {0.0, 0.2, 0.4, 0.6, 0.8, 1.0};
    robot.forceSaturation = 150.0;
    return robot;
}

/// Returns an artificial model with surface processes over 300 scenes on nearly flat ground.
ModelData someClearances(const RobotModel& robot)
{
    std::mt19937_64 rng(4);
    ModelData model = someModel();
    model.features.resize(model.heights.rows(), kFeatures);
    for (double& x : model.features.reshaped()) x = 0.6 * (uniform(rng) - 0.5);
    model.features.rightCols(kForceElements).array() += 0.5;
    const Eigen::MatrixXd ceilings = bodyCeilings(model.features, robot);
    prepareClearance(model, ceilings);
    ClearanceData& data = model.clearance;
    data.noveltyScale = 1.0;
    data.contactSd = 0.03;
    for (double& x : data.residuals.reshaped()) x = 0.4 * (uniform(rng) - 0.5);
    for (int bin = 0; bin < kBins; ++bin)
        for (const bool covered : {false, true}) {
            auto& process = (covered ? data.covered : data.open)[static_cast<std::size_t>(bin)];
            const auto rows = inducingRows(rowsOf(data.coveredBins, {}, bin, covered));
            process.mean = covered ? 0.5 : -0.3;
            process.residualSd = 0.1;
            if (rows.empty()) continue;
            process.hyper = {Eigen::VectorXd::Constant(kFeatures, 2.0), 0.2, 0.05};
            process.weights.resize(static_cast<Eigen::Index>(rows.size()));
            for (double& w : process.weights) w = 0.1 * (uniform(rng) - 0.5);
        }
    return model;
}

ClearanceConditionals someConditionals(const ModelData& model, const RobotModel& robot)
{
    ClearanceTraining training = clearanceTraining(model, robot);
    ClearanceConditionalData data = prepareClearanceConditionals(training);
    for (int bin = 0; bin < kBins; ++bin)
        for (const Regime regime : kRegimes) {
            ClearanceRegimeData& own = data.at(bin, regime);
            own.hyper = {Eigen::VectorXd::Constant(kBins - 1 + kFeatures, 4.0), own.sd,
                         0.3 * own.sd};
        }
    return {std::move(training), std::move(data)};
}

Hash hashOf(const TerrainEstimate& estimate)
{
    Hash hash;
    for (const Heights& h : {estimate.mean, estimate.sd, estimate.q10, estimate.q90,
                             estimate.height, estimate.rhat, estimate.ess})
        hash.add(h);
    for (const Heights& h : estimate.draws) hash.add(h);
    hash.add(&estimate.novelty, 1);
    return hash;
}

/// Returns the hash of an estimate of the model's first scene, with one probe.
Hash hashOfEstimate(Method method)
{
    const RobotModel robot = someRobot();
    const ModelData model = someClearances(robot);
    FeatureValues values{};
    for (std::size_t d = 0; d < kFeatures; ++d)
        values[d] = model.features(0, static_cast<Eigen::Index>(d));
    const Proprioception s = proprioception(values);
    const std::vector<ArmReading> arm{{9, -0.27, 0.03}};
    Settings settings;
    settings.method = method;
    settings.contacts = ContactRule::None;
    settings.draws = 400;
    settings.chains = 8;
    settings.burnIn = 5;
    if (method != Method::Clearance)
        return hashOf(reconstructClosedForm(s, arm, robot, ClearanceModel(model), settings));
    return hashOf(
        sampleScene(clearanceSampling(s, arm, robot, someConditionals(model, robot), settings)));
}

void print(const char* what, const Hash& hash)
{
    std::printf("%s %016llx\n", what, static_cast<unsigned long long>(hash.value()));
}

}  // namespace
}  // namespace terratact

/// Usage: same_draws <threads>.
int main(int argc, char** argv)
{
    using namespace terratact;
    print("draws", hashOfDraws());
    const Hashes hashes = hashesIn(argc > 1 ? std::atoi(argv[1]) : 1);
    print("states", hashes.states);
    print("double", hashes.inDouble);
    print("sparse", hashes.throughFewRows);
    print("estimate", hashes.estimate);
    for (const Method method : {Method::Local, Method::Joint, Method::Clearance})
        print(std::string(name(method)).c_str(), hashOfEstimate(method));
    return 0;
}
