#include "app/modelling/trials/drive_trials.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "app/runtime/parallel.h"
#include "app/runtime/stopwatch.h"
#include "core/infer/two_track_estimator.h"
#include "core/learn/data/drive_copies.h"
#include "core/learn/data/drive_file.h"
#include "core/learn/model/surface_rows.h"
#include "core/trail/trail_record.h"

namespace terratact {
namespace {

constexpr std::size_t kDrivesPerTurn = 32;

/// Judged scenes of one drive, by method.
struct JudgedScenes {
    std::vector<std::vector<JudgedSide>> sides;
    std::vector<std::vector<double>> cpu;  ///< [s]
    std::size_t early = 0, whole = 0, failed = 0;
};

class DriveJudge {
public:
    DriveJudge(const EstimatorBundle& bundle, const std::vector<Method>& methods,
               const Settings& settings)
        : bundle_(bundle), methods_(methods), settings_(settings)
    {
    }

    JudgedScenes run(const DriveLines& drive) const
    {
        JudgedScenes judged;
        judged.sides.resize(methods_.size());
        judged.cpu.resize(methods_.size());
        TrailRecord record(bundle_.robot);
        for (const DriveLine& line : drive.lines) {
            if (!line.isScene) {
                record.add(line.line);
                continue;
            }
            judge(line, drive.onePlane, record, judged);
            record.addScene(line.line);
        }
        return judged;
    }

private:
    void judge(const DriveLine& line, bool onePlane, const TrailRecord& record,
               JudgedScenes& judged) const
    {
        const bool early = record.length() < kWholeMemory;
        ++(early ? judged.early : judged.whole);
        for (std::size_t m = 0; m < methods_.size(); ++m) {
            Settings own = settings_;
            own.method = methods_[m];
            const ProcessorStopwatch watch;
            try {
                const bool isTrail = own.method == Method::Trail;
                const TrailHistory history = isTrail ? record.before(line.line) : TrailHistory{};
                const TwoTrackEstimate estimate = estimateMeasured(
                    line.line, {}, bundle_.robot, bundle_.models, own, {}, &history);
                judged.cpu[m].push_back(watch.seconds());
                for (std::size_t side = 0; side < (onePlane ? 1U : 2U); ++side)
                    judged.sides[m].push_back(
                        judgedSide(estimate.side.at(side), line.truth.at(side), early));
            } catch (const std::invalid_argument&) {  // RefusedInput, too
                ++judged.failed;
            }
        }
    }

    const EstimatorBundle& bundle_;
    const std::vector<Method>& methods_;
    const Settings& settings_;
};

template <class T>
void appendAll(std::vector<T>& to, const std::vector<T>& more)
{
    to.insert(to.end(), more.begin(), more.end());
}

/// Counts drives and scenes that networks and model were trained on.
class TrainingCounter {
public:
    explicit TrainingCounter(const EstimatorBundle& bundle) : model_(bundle.model.data)
    {
        if (!bundle.models.trail) return;
        const TrailData& data = bundle.models.trail->data();
        for (const TrailNetworks* networks : {&data.plane, &data.side})
            for (const DriveMarks& marks : networks->drives) networks_.add(marks);
    }

    void add(const std::vector<DriveLines>& drives)
    {
        std::vector<Scene> planes;
        std::vector<TwoTrackScene> tracks;
        for (const DriveLines& drive : drives) {
            if (networks_.contains(driveMarks(drive))) ++drives_;
            if (drive.onePlane || !model_.hasSides())
                appendAll(planes, planeScenesOf(drive));
            else
                appendAll(tracks, trackScenesOf(drive));
        }
        scenes_ += trainingScenes(planes, model_) + trainingScenes(tracks, model_.sides);
    }

    std::size_t drives() const { return drives_; }
    std::size_t scenes() const { return scenes_; }

private:
    const ModelData& model_;
    DriveCopies networks_;
    std::size_t drives_ = 0, scenes_ = 0;
};

/// Judges drives as they are read, some at a time.
class DriveJudges {
public:
    DriveJudges(const DriveJudge& judge, const EstimatorBundle& bundle, std::size_t methods)
        : judge_(judge), training_(bundle)
    {
        all_.sides.resize(methods);
        all_.cpu.resize(methods);
    }

    void add(DriveLines&& drive)
    {
        waiting_.push_back(std::move(drive));
        if (waiting_.size() == kDrivesPerTurn) flush();
    }

    void flush()
    {
        std::vector<JudgedScenes> judged(waiting_.size());
        parallelFor(static_cast<int>(waiting_.size()), [&](int k) {
            const auto drive = static_cast<std::size_t>(k);
            judged[drive] = judge_.run(waiting_[drive]);
        });
        for (const JudgedScenes& drive : judged) {
            for (std::size_t m = 0; m < all_.sides.size(); ++m) {
                appendAll(all_.sides[m], drive.sides[m]);
                appendAll(all_.cpu[m], drive.cpu[m]);
            }
            all_.early += drive.early;
            all_.whole += drive.whole;
            all_.failed += drive.failed;
            ++drives_;
        }
        training_.add(waiting_);
        waiting_.clear();
    }

    const JudgedScenes& all() const { return all_; }
    std::size_t drives() const { return drives_; }
    const TrainingCounter& training() const { return training_; }

private:
    const DriveJudge& judge_;
    TrainingCounter training_;
    std::vector<DriveLines> waiting_;
    JudgedScenes all_;
    std::size_t drives_ = 0;
};

std::string scoreTable(const std::vector<DriveScores>& scores)
{
    constexpr double kMm = 1000.0;
    std::string text = fmt::format("{:8} {:>7} {:>7} {:>7}   {}\n", "method", "median", "mean",
                                   "in 80%", "median by bin, -0.3 ... 0.7 m");
    for (const DriveScores& s : scores) {
        text += fmt::format("{:8} {:7.2f} {:7.2f} {:7.1f}  ", s.name, kMm * s.median, kMm * s.mean,
                            100.0 * s.in80);
        for (const double median : s.medians) text += fmt::format(" {:5.1f}", kMm * median);
        text += '\n';
    }
    return text;
}

std::string coverTable(const std::vector<DriveScores>& scores)
{
    std::string text =
        fmt::format("{:8} {:>9}   {}\n", "method", "CPU [ms]", "80 % bands cover [%], by bin");
    for (const DriveScores& s : scores) {
        text += fmt::format("{:8} {:9.2f}  ", s.name, 1000.0 * s.cpu);
        for (const double cover : s.cover) text += fmt::format(" {:5.1f}", 100.0 * cover);
        text += '\n';
    }
    return text;
}

}  // namespace

Result<DriveFindings> judgeDriveFile(const std::string& path, const EstimatorBundle& bundle,
                                     const std::vector<Method>& methods, const Settings& settings,
                                     const std::function<void(const Message&)>& notice)
{
    const DriveJudge judge(bundle, methods, settings);
    DriveJudges judges(judge, bundle, methods.size());
    const auto read = readDrives(path, [&](DriveLines&& drive) { judges.add(std::move(drive)); });
    if (!read) return read.error();
    for (const Message& sentence : *read) notice(sentence);
    judges.flush();
    const JudgedScenes& all = judges.all();
    DriveFindings findings{.drives = judges.drives(),
                           .scenes = all.whole,
                           .early = all.early,
                           .failed = all.failed,
                           .trainingDrives = judges.training().drives(),
                           .trainingScenes = judges.training().scenes(),
                           .whole = {},
                           .begin = {}};
    for (std::size_t m = 0; m < methods.size(); ++m) {
        const std::string label(name(methods[m]));
        findings.whole.push_back(scoresOf(label, all.sides[m], false, all.cpu[m]));
        findings.begin.push_back(scoresOf(label, all.sides[m], true, all.cpu[m]));
    }
    return findings;
}

std::string driveTable(const DriveFindings& findings)
{
    std::string text = fmt::format(
        "{} drives\n\n{} scenes after {:.2f} m of way or more, bins -0.3 ... 0.5 m [mm]\n",
        findings.drives, findings.scenes, kWholeMemory);
    text += scoreTable(findings.whole) + "\n" + coverTable(findings.whole);
    text += fmt::format("\n{} scenes before, at the begin of a drive\n", findings.early);
    text += scoreTable(findings.begin);
    if (findings.failed > 0) text += fmt::format("{} estimates failed\n", findings.failed);
    return text;
}

}  // namespace terratact
