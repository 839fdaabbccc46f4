// Gives Gaussian processes like those of the method local the memory of the way as further inputs. Searches the
// relevant inputs. Drives are simulated, in one plane (terratact simulate --drives). Processes learn from the first
// file, one per bin and regime. Their length scales maximise the likelihood of at most ROWS scenes. The number of
// inputs is that with the least mean error on the second file. The other files are judged with it, beside local and
// trail.
//   terratact-bench-history ROWS TRAINING.csv CHOICE.csv DRIVES.csv...
// The same files give the same errors. CPU time depends on the machine. That of the processes is without the inputs.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/modelling/trials/drive_trials.h"
#include "app/runtime/parallel.h"
#include "app/runtime/stopwatch.h"
#include "core/infer/estimate/quantile.h"
#include "core/learn/data/drive_file.h"
#include "core/learn/gp/projected_process.h"
#include "core/learn/kernels/covariance_block.h"
#include "core/learn/kernels/hyperparameters.h"
#include "core/learn/model/bin_models.h"
#include "core/learn/model/clearance.h"
#include "core/learn/model/surface_rows.h"
#include "core/learn/model/training.h"
#include "core/trail/trail_history.h"
#include "core/trail/trail_training.h"
#include "tests/bench/shipped_bundle.h"

extern "C" void openblas_set_num_threads(int);

namespace terratact {
namespace {

constexpr std::uint64_t kSeed = 1;
/// Inputs: planeInputs() without the covered bins. The scene's features come first, the way last.
constexpr int kInputs = int{kFeatures} + int{kTrailPlaces} + 3 * int{kTrailBins} + 1;
constexpr std::array kKept{12, 24};                // numbers of inputs to choose from, beside all
constexpr int kEvaluations = 100;                  // of the likelihood, in each search
constexpr SearchBounds kBounds{.mostNoise = 3.0};  // as in clearance_training.cpp

/// Scenes of drives; every height is known.
struct Scenes {
    TrailRows rows;
    Eigen::MatrixXd X{};  ///< n × kInputs
};

/// cut: some scenes know a part of their way, as in the training of the networks.
Scenes scenesIn(const std::string& path, const RobotModel& robot, bool cut)
{
    const std::vector<DriveLines> drives = valueOf(readDrives(path)).drives;
    std::vector<TrailRows> parts(drives.size());
    parallelFor(static_cast<int>(drives.size()), [&](int k) {
        const auto drive = static_cast<std::size_t>(k);
        const int number = cut ? k : k * kErrorDrives;
        parts[drive] = trailRows(std::span(&drives[drive], 1), number, robot, false, kSeed);
    });
    Scenes scenes{joined(parts)};
    scenes.X = scenes.rows.inputs.topRows(kInputs).transpose().cast<double>();
    return scenes;
}

/// Mean and sd of each input over the training scenes; sd 1 of an input that never varies.
struct InputScale {
    explicit InputScale(const Eigen::MatrixXd& X) : mean(X.colwise().mean().transpose())
    {
        const Eigen::MatrixXd centred = X.rowwise() - mean.transpose();
        sd = centred.array().square().colwise().mean().sqrt().matrix().transpose();
        sd = (sd.array() < 1e-9).select(1.0, sd);
    }
    void apply(Scenes& scenes) const { scenes.X = standardised(scenes.X, mean, sd); }
    Eigen::VectorXd mean, sd;
};

/// Process of a bin in one regime. With fewer than kMinTrainingRows scenes it has the mean alone.
struct BinProcess {
    std::vector<int> inputs{};  ///< numbers of those that it uses
    std::size_t scenes = 0;     ///< of training
    double mean = 0.0;          ///< of the surface coordinate
    Hyperparameters hyper{};
    ScaledRows inducing{};
    Eigen::VectorXd weights{};
    std::vector<double> errors{0.0};  ///< ascending, of each scene without its own drive
};

/// Of bin i: number 2 i where the robot does not cover it, and 2 i + 1 where it does.
using BinProcesses = std::vector<BinProcess>;

/// Learns as trainSurface() does (core/learn/model/clearance_training.h). y: centred; drives: of the rows.
void learn(BinProcess& process, const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
           const std::vector<int>& drives, const TrainingOptions& search)
{
    const double sd = std::sqrt(y.squaredNorm() / static_cast<double>(y.size()));
    process.hyper = maximiseLikelihood(X, y, searchStart(X.cols(), sd), search, kBounds).hyper;
    std::vector<int> positions(drives.size());
    std::iota(positions.begin(), positions.end(), 0);
    const std::vector<int> inducing = inducingRows(positions);
    const ProjectedProcess projected = projectProcess(X, y, inducing, process.hyper, {}, drives);
    process.inducing = inLengthScales(X(inducing, Eigen::all), process.hyper);
    process.weights = projected.weights;
    process.errors.assign(projected.leaveOneOut.begin(), projected.leaveOneOut.end());
    std::ranges::sort(process.errors);
}

BinProcess learnt(const Scenes& scenes, int bin, bool covered, std::vector<int> inputs,
                  const TrainingOptions& search)
{
    const std::vector<int> rows = rowsOf(scenes.rows.covered, {}, bin, covered);
    BinProcess process{.inputs = std::move(inputs), .scenes = rows.size()};
    std::vector<int> drives;
    Eigen::VectorXd y(std::ssize(rows));
    for (const int row : rows) {
        y[std::ssize(drives)] =
            toSurface(scenes.rows.heights(bin, row), scenes.rows.ceilings(bin, row));
        drives.push_back(scenes.rows.drive[static_cast<std::size_t>(row)]);
    }
    if (!rows.empty()) process.mean = y.mean();
    y.array() -= process.mean;
    if (y.size() >= kMinTrainingRows)
        learn(process, scenes.X(rows, process.inputs), y, drives, search);
    return process;
}

/// chosenInputs: of the process with that number.
BinProcesses trained(const Scenes& scenes, const TrainingOptions& search,
                     const std::function<std::vector<int>(std::size_t)>& chosenInputs)
{
    BinProcesses processes(2 * kBins);
    parallelFor(2 * kBins, [&](int k) {
        const auto process = static_cast<std::size_t>(k);
        processes[process] = learnt(scenes, k / 2, k % 2 == 1, chosenInputs(process), search);
    });
    return processes;
}

double surfaceAt(const BinProcess& process, const Scenes& scenes, Eigen::Index u)
{
    if (process.weights.size() == 0) return process.mean;
    const Eigen::RowVectorXd x = scenes.X(u, process.inputs);
    const double variance = std::pow(process.hyper.signalSd, 2);
    return process.mean + covarianceColumn(process.inducing, x, variance).dot(process.weights);
}

TerrainEstimate estimateOf(const BinProcesses& processes, const Scenes& scenes, Eigen::Index u)
{
    TerrainEstimate estimate;
    for (std::size_t i = 0; i < kBins; ++i) {
        const double ceiling = scenes.rows.ceilings(static_cast<Eigen::Index>(i), u);
        const bool covered = std::isfinite(ceiling);
        const BinProcess& process = processes.at(2 * i + (covered ? 1U : 0U));
        const double y = surfaceAt(process, scenes, u);
        const auto heightAt = [&](double p) {  // a covered bin is low where y is large
            return toHeight(y + quantileOfSorted(process.errors, covered ? 1.0 - p : p), ceiling);
        };
        estimate.height.at(i) = heightAt(0.5);
        estimate.q10.at(i) = heightAt(0.1);
        estimate.q90.at(i) = heightAt(0.9);
    }
    return estimate;
}

/// Returns the scores of the scenes after a way of kWholeMemory, and of those before.
std::array<DriveScores, 2> scored(const std::string& name, const BinProcesses& processes,
                                  const Scenes& scenes)
{
    std::vector<JudgedSide> sides(scenes.rows.drive.size());
    std::vector<double> cpu(sides.size());
    parallelFor(static_cast<int>(sides.size()), [&](int u) {
        const ProcessorStopwatch watch;
        const TerrainEstimate estimate = estimateOf(processes, scenes, u);
        const auto scene = static_cast<std::size_t>(u);
        cpu[scene] = watch.seconds();
        OptionalHeights truth;
        for (int i = 0; i < kBins; ++i)
            truth.at(static_cast<std::size_t>(i)) = scenes.rows.heights(i, u);
        const double way = scenes.rows.inputs(kInputs - 1, u);
        sides[scene] = judgedSide(estimate, truth, way < kWholeMemory);
    });
    return {scoresOf(name, sides, false, cpu), scoresOf(name, sides, true, cpu)};
}

/// Returns so many inputs; those with the largest relevance come first.
std::vector<int> mostRelevant(int count, const Eigen::VectorXd& relevance)
{
    std::vector<int> inputs(static_cast<std::size_t>(kInputs));
    std::iota(inputs.begin(), inputs.end(), 0);
    std::ranges::stable_sort(inputs, std::ranges::greater{}, [&](int j) { return relevance[j]; });
    inputs.resize(static_cast<std::size_t>(count));
    return inputs;
}

/// Returns 1 / length scale of each input of a process over all inputs; 0 if the mean alone counts.
Eigen::VectorXd relevanceOf(const BinProcess& process)
{
    if (process.weights.size() == 0) return Eigen::VectorXd::Zero(kInputs);
    return process.hyper.lengthScale.cwiseInverse();
}

std::vector<std::string> inputNames()
{
    std::vector<std::string> names;
    for (const auto name : featureNames(FeatureSet::Paf)) names.emplace_back(name);
    for (std::size_t k = 1; k <= kTrailPlaces; ++k)
        names.push_back(fmt::format("pitch {:+.1f} m", -kTrailPlaceStep * static_cast<double>(k)));
    for (const char* what : {"passed", "load", "pressed"})
        for (int i = 0; i < int{kTrailBins}; ++i)
            names.push_back(fmt::format("{} {:+.1f} m", what, binCentre(i)));
    names.emplace_back("way");
    return names;
}

/// Prints the mean relevance of each input over the bins -0.3 ... 0.5 m, in the process of a bin with more scenes.
void showRelevance(const BinProcesses& all)
{
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(kInputs);
    for (std::size_t bin = 0; bin < kTrailBins; ++bin) {
        const BinProcess &open = all.at(2 * bin), &covered = all.at(2 * bin + 1);
        mean += relevanceOf(open.scenes > covered.scenes ? open : covered) / double{kTrailBins};
    }
    const std::vector<std::string> names = inputNames();
    std::printf("%-20s relevance\n", "input");
    for (const int input : mostRelevant(kInputs, mean))
        std::printf("%-20s %9.3f\n", names[static_cast<std::size_t>(input)].c_str(), mean[input]);
}

/// Returns the processes with the least mean error on `choice`: over all inputs, or over the most relevant ones.
BinProcesses chosen(const BinProcesses& all, const Scenes& training, const TrainingOptions& search,
                    const Scenes& choice)
{
    std::vector<BinProcesses> candidates{all};
    for (const int kept : kKept)
        candidates.push_back(trained(training, search, [&](std::size_t k) {
            return mostRelevant(kept, relevanceOf(all[k]));
        }));
    std::printf("\nchoice [mm]\n%6s %7s %7s %7s\n", "inputs", "median", "mean", "in 80%");
    std::vector<double> means;
    for (const BinProcesses& some : candidates) {
        const DriveScores scores = scored("history", some, choice)[0];
        std::printf("%6zu %7.2f %7.2f %7.1f\n", some.front().inputs.size(), 1000.0 * scores.median,
                    1000.0 * scores.mean, 100.0 * scores.in80);
        means.push_back(scores.mean);
    }
    return candidates[static_cast<std::size_t>(std::ranges::min_element(means) - means.begin())];
}

void judge(const std::string& path, const EstimatorBundle& bundle, const InputScale& scale,
           const BinProcesses& scene, const BinProcesses& history)
{
    DriveFindings findings = valueOf(
        judgeDriveFile(path, bundle, {Method::Local, Method::Trail}, {}, [](const Message&) {}));
    Scenes scenes = scenesIn(path, bundle.robot, false);
    scale.apply(scenes);
    for (const BinProcesses* processes : {&scene, &history}) {
        const auto [whole, begin] =
            scored(processes == &scene ? "scene" : "history", *processes, scenes);
        findings.whole.push_back(whole);
        findings.begin.push_back(begin);
    }
    std::printf("\n%s, history of %zu inputs: %s", path.c_str(), history.front().inputs.size(),
                driveTable(findings).c_str());
}

}  // namespace
}  // namespace terratact

int main(int count, char** arguments)
{
    using namespace terratact;
    const TrainingOptions search{.subset = count > 4 ? std::atoi(arguments[1]) : 0,
                                 .subsetEvaluations = kEvaluations,
                                 .fullEvaluations = 0};
    if (search.subset < kMinTrainingRows) {
        std::fprintf(stderr, "usage: %s ROWS TRAINING.csv CHOICE.csv DRIVES.csv...\n", *arguments);
        return 2;
    }
    openblas_set_num_threads(1);
    const auto bundle = shippedBundle();
    Scenes training = scenesIn(arguments[2], bundle->robot, true);
    Scenes choice = scenesIn(arguments[3], bundle->robot, false);
    const InputScale scale(training.X);
    for (Scenes* scenes : {&training, &choice}) scale.apply(*scenes);
    const auto withFirst = [&](int inputs) {  // without relevance, their order stays
        const std::vector<int> first = mostRelevant(inputs, Eigen::VectorXd::Zero(kInputs));
        return trained(training, search, [&](std::size_t) { return first; });
    };
    const BinProcesses scene = withFirst(int{kFeatures}), all = withFirst(kInputs);
    showRelevance(all);
    const BinProcesses history = chosen(all, training, search, choice);
    for (int k = 4; k < count; ++k) judge(arguments[k], *bundle, scale, scene, history);
    return EXIT_SUCCESS;
}
