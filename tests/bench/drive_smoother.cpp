// Compares an ensemble Kalman smoother over the drive with the methods local and trail. The drives are simulated, in
// one plane and without soft ground (terratact simulate --drives). Reach and relaxation of the smoother are those with
// the least mean error on the first file. The other files are judged with them.
//   terratact-bench-smoother MEMBERS CHOICE.csv DRIVES.csv...
// The same files give the same errors. CPU time depends on the machine. That of the smoother is of the way since the
// stop before, and of the press.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "app/modelling/trials/drive_trials.h"
#include "app/runtime/parallel.h"
#include "app/runtime/stopwatch.h"
#include "core/learn/data/drive_file.h"
#include "core/trail/trail_record.h"
#include "tests/bench/drive_ensemble.h"
#include "tests/bench/shipped_bundle.h"

extern "C" void openblas_set_num_threads(int);

namespace terratact {
namespace {

constexpr std::uint32_t kSeed = 1;

/// Scenes of drives as the smoother sees them.
struct SmoothedScenes {
    std::vector<JudgedSide> sides;
    std::vector<double> cpu;  ///< [s]
    std::size_t failed = 0;   ///< stops without a rest pose on any member

    void add(const SmoothedScenes& more)
    {
        sides.insert(sides.end(), more.sides.begin(), more.sides.end());
        cpu.insert(cpu.end(), more.cpu.begin(), more.cpu.end());
        failed += more.failed;
    }
    DriveScores scores(bool early) const { return scoresOf("smoother", sides, early, cpu); }
};

double wayOf(const DriveLines& drive)
{
    return drive.lines.back().line.travelled.value() - drive.lines.front().line.travelled.value();
}

/// number: of the drive in its file, for its draws.
SmoothedScenes smoothedDrive(const DriveLines& drive, std::uint32_t number, const RobotModel& robot,
                             const EnsembleOptions& options)
{
    std::seed_seq seed{kSeed, number};
    DriveEnsemble ensemble(robot, options, wayOf(drive), seed);
    TrailRecord record(robot);
    SmoothedScenes scenes;
    double cpu = 0.0;
    for (const DriveLine& line : drive.lines) {
        const ProcessorStopwatch watch;
        if (!line.isScene) {
            ensemble.drive(line.line);
            cpu += watch.seconds();
            record.add(line.line);
            continue;
        }
        const auto estimate = ensemble.press(line.line);
        scenes.cpu.push_back(std::exchange(cpu, 0.0) + watch.seconds());
        const bool early = record.length() < kWholeMemory;
        if (estimate)
            scenes.sides.push_back(judgedSide(*estimate, line.truth[0], early));
        else
            ++scenes.failed;
        record.addScene(line.line);
    }
    return scenes;
}

SmoothedScenes smoothed(const std::vector<DriveLines>& drives, const RobotModel& robot,
                        const EnsembleOptions& options)
{
    std::vector<SmoothedScenes> parts(drives.size());
    parallelFor(static_cast<int>(drives.size()), [&](int k) {
        const auto drive = static_cast<std::size_t>(k);
        parts[drive] = smoothedDrive(drives[drive], static_cast<std::uint32_t>(k), robot, options);
    });
    SmoothedScenes all;
    for (const SmoothedScenes& part : parts) all.add(part);
    return all;
}

/// Returns the options with the least mean error on the drives, and prints what each gives.
EnsembleOptions chosen(const std::string& path, const RobotModel& robot, EnsembleOptions options)
{
    const std::vector<DriveLines> drives = valueOf(readDrives(path)).drives;
    std::printf("choice on %s: %zu drives, %ld members [mm]\n%9s %11s %7s %7s %7s\n", path.c_str(),
                drives.size(), static_cast<long>(options.members), "reach [m]", "relaxation",
                "median", "mean", "in 80%");
    EnsembleOptions best = options;
    double least = std::numeric_limits<double>::infinity();
    for (const double reach : {0.5, 1.0}) {
        for (const double relaxation : {0.0, 0.3, 0.6}) {
            options.reach = reach;
            options.relaxation = relaxation;
            const DriveScores scores = smoothed(drives, robot, options).scores(false);
            std::printf("%9.1f %11.1f %7.2f %7.2f %7.1f\n", reach, relaxation,
                        1000.0 * scores.median, 1000.0 * scores.mean, 100.0 * scores.in80);
            if (scores.mean < least) best = options;
            least = std::min(least, scores.mean);
        }
    }
    std::printf("chosen: reach %.1f m, relaxation %.1f\n", best.reach, best.relaxation);
    return best;
}

void judge(const std::string& path, const EstimatorBundle& bundle, const EnsembleOptions& options)
{
    DriveFindings findings = valueOf(
        judgeDriveFile(path, bundle, {Method::Local, Method::Trail}, {}, [](const Message&) {}));
    const SmoothedScenes scenes = smoothed(valueOf(readDrives(path)).drives, bundle.robot, options);
    findings.whole.push_back(scenes.scores(false));
    findings.begin.push_back(scenes.scores(true));
    findings.failed += scenes.failed;
    std::printf("\n%s: %s", path.c_str(), driveTable(findings).c_str());
}

}  // namespace
}  // namespace terratact

int main(int count, char** arguments)
{
    using namespace terratact;
    const int members = count > 3 ? std::atoi(arguments[1]) : 0;
    if (members < 2) {
        std::fprintf(stderr, "usage: %s MEMBERS CHOICE.csv DRIVES.csv...\n", arguments[0]);
        return 2;
    }
    openblas_set_num_threads(1);
    const auto bundle = shippedBundle();
    const EnsembleOptions options{.members = members, .groundSd = postsSd(bundle->robot, kSeed)};
    const EnsembleOptions best = chosen(arguments[2], bundle->robot, options);
    for (int k = 3; k < count; ++k) judge(arguments[k], *bundle, best);
    return EXIT_SUCCESS;
}
