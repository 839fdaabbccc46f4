#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "app/cli/session_commands.h"
#include "app/modelling/scene_estimates.h"
#include "app/recording/scene_origins.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "app/runtime/interrupt.h"
#include "app/runtime/parallel.h"
#include "app/runtime/progress.h"
#include "app/runtime/say.h"
#include "app/runtime/text_output.h"
#include "core/base/text.h"
#include "core/eval/calibration_ledger.h"
#include "core/eval/evaluation.h"
#include "core/log/later_poses.h"
#include "core/store/csv_text.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"

namespace terratact {

namespace {

/// Returns the settings of a recorded estimate with the requested changes.
Settings changed(Settings settings, const WhatIfOptions& options)
{
    if (options.method) settings.method = *options.method;
    if (options.preset) settings = withPreset(settings, *options.preset);
    if (options.threshold) settings.forceThreshold = *options.threshold;
    if (options.seed) settings.seed = *options.seed;
    return settings;
}

/// Cache of models by robot and file.
class Toolboxes {
public:
    Result<const EstimatorBundle*> get(const RobotModel& robot, const std::string& robotText,
                                       const std::string& path)
    {
        auto& bundle = open_[{robotText, path}];
        if (!bundle) {
            auto model = readModel(path);
            if (!model) return model.error();
            bundle = std::make_unique<EstimatorBundle>(robot, std::move(*model));
        }
        return static_cast<const EstimatorBundle*>(bundle.get());
    }

private:
    std::map<std::pair<std::string, std::string>, std::unique_ptr<EstimatorBundle>> open_;
};

/// One recorded estimate and its recomputation.
struct Rerun {
    const SessionReader* session = nullptr;
    EstimateRow row;  ///< with draws
    TerrainEstimate again;
    Differences differences;
    bool asRecorded = false;  ///< no change was requested
};

std::size_t sessionsOf(const std::vector<Rerun>& reruns)
{
    std::set<const SessionReader*> sessions;
    for (const Rerun& rerun : reruns) sessions.insert(rerun.session);
    return sessions.size();
}

Scene evaluated(const SceneRow& row)
{
    Scene scene{
        .run = {}, .time = secondsOf(row.time), .s = proprioception(row.measurement), .truth = {}};
    if (row.truth)
        for (std::size_t i = 0; i < kBins; ++i) scene.truth[i] = (*row.truth)[i];
    return scene;
}

class WhatIf {
public:
    explicit WhatIf(const WhatIfOptions& options) : options_(options) {}

    Status run(const std::string& file)
    {
        auto session = SessionReader::open(file);
        if (!session) return session.error();
        sessions_.push_back(std::make_unique<SessionReader>(std::move(*session)));
        SessionReader& reader = *sessions_.back();
        for (const SessionDamage& damage : reader.damage())
            say(stderr, "terratact: {}: left out: {}\n", file, damageText(reader.start(), damage));
        const std::set<std::int64_t> repeated = origins_.take(reader);
        bool any = false;
        for (const EstimateRow& row : reader.estimates()) {
            if (options_.estimate != 0 && row.id != options_.estimate) continue;
            if (interrupt_.came()) throw Cancelled{};
            any = true;
            if (repeated.contains(row.scene)) continue;
            if (Status done = repeat(reader, row); !done) return done;
        }
        if (!any && options_.estimate != 0)
            return fileError(file, fmt::format("has no estimate {}", options_.estimate));
        return Done{};
    }

    Status conclude() const
    {
        if (reruns_.empty()) return Error{options_.files.front() + ": holds no estimate"};
        for (const Rerun& rerun : reruns_) print(rerun);
        if (reruns_.size() > 1) summarise();
        printScores();
        printLedger("later probes against the bands before them",
                    [this](SessionReader& session) { return laterProbes(session); });
        printLedger("contacts and probes at later poses against the bands that odometry took there",
                    [this](SessionReader& session) { return laterPosesOf(session); });
        if (!options_.out.empty())
            if (Status written = writeText(options_.out, csv()); !written) return written;
        const auto failed = std::count_if(reruns_.begin(), reruns_.end(), [](const Rerun& r) {
            return r.asRecorded && r.differences.likeness == Match::Other && !endedByTime(r);
        });
        if (failed == 0) return Done{};
        return Error{fmt::format("{} of {} estimates do not come out as they were recorded", failed,
                                 reruns_.size())};
    }

private:
    static bool endedByTime(const Rerun& rerun)
    {
        return rerun.row.estimate.ending == Ending::Time;
    }

    Result<std::string> modelPath(const SessionReader& session, const EstimateRow& row,
                                  bool& recordedOne) const
    {
        const ModelRow* model = session.model(row.model);
        if (!model)
            return fileError(session.path(),
                             fmt::format("estimate {}: its model is not there", row.id));
        if (options_.model.empty()) {
            const auto path = modelFileOf(*model, std::array{options_.shippedModel});
            recordedOne = true;
            if (path) return *path;
            return Error{path.error().text + "; --model FILE names it or another"};
        }
        const auto hash = sha256OfFile(options_.model);
        if (!hash) return hash.error();
        recordedOne = *hash == model->hash;
        return options_.model;
    }

    Status repeat(SessionReader& session, const EstimateRow& row)
    {
        const auto robot = robotOf(session);
        if (!robot) return robot.error();
        bool recordedModel = false;
        const auto path = modelPath(session, row, recordedModel);
        if (!path) return path.error();
        const auto bundle = toolboxes_.get(*robot, session.start().robot, *path);
        if (!bundle) return bundle.error();
        auto before = recordedEstimate(session, row);
        if (!before) return before.error();
        Watch watch;
        lendProcessors(watch);
        Progress progress(fmt::format("estimate {}: percent", row.id), 100);
        watch.progress = [&](double share) { progress.reach(static_cast<int>(100.0 * share)); };
        watch.cancelled = [this] { return interrupt_.came(); };
        const Settings settings = changed(row.estimate.settings, options_);
        auto again = estimateAgain(session, row, (*bundle)->models, settings, watch);
        if (!again) return again.error();
        Rerun rerun{.session = &session, .row = row, .again = std::move(*again), .differences = {}};
        rerun.row.estimate = std::move(*before);
        rerun.asRecorded = recordedModel && settings == row.estimate.settings;
        rerun.differences = differencesBetween(
            rerun.row.estimate, rerun.again, session.scene(row.scene)->measurement, row.stepLimit);
        reruns_.push_back(std::move(rerun));
        return Done{};
    }

    static std::string words(const Verdict& verdict)
    {
        return fmt::format("{} (step ahead {:.0f} %)", describeStepVerdict(verdict),
                           100.0 * verdict.step.p);
    }

    void print(const Rerun& r) const
    {
        const Differences& d = r.differences;
        say(messages_, "{}: estimate {} of scene {} at {}, {}: ", r.session->path(), r.row.id,
            r.row.scene, momentText(r.row.time), name(r.row.estimate.settings.method));
        const bool identical = d.likeness == Match::Identical;
        if (r.asRecorded && identical) {
            say(messages_, "reproduced bit for bit\n");
            return;
        }
        if (r.asRecorded && d.likeness == Match::LastBits) {
            say(messages_,
                "reproduced but for the last bits of another processor or version, "
                "heights within {:.1g} m\n",
                d.largest());
            return;
        }
        if (r.asRecorded && endedByTime(r))
            say(messages_, "its sampling was ended by time, which nothing repeats\n");
        else if (r.asRecorded)
            say(messages_, "NOT reproduced, heights differ by up to {:.1g} m\n", d.largest());
        else
            say(messages_, "now {}{}\n", name(r.again.settings.method),
                identical ? ", the same bit for bit" : "");
        if (identical) return;
        say(messages_, "   bin   height [m]           sd [mm]      80 % band [m]\n"
                       "   [m]   then     now  moved  then  now   then              now\n");
        for (std::size_t i = 0; i < kBins; ++i) {
            const TerrainEstimate &a = r.row.estimate, &b = r.again;
            say(messages_,
                "  {:+.1f} {:+.3f}  {:+.3f}  {:+5.0f} {:5.0f} {:4.0f}   {:+.3f} … {:+.3f}   "
                "{:+.3f} … {:+.3f}\n",
                binCentre(static_cast<int>(i)), a.height[i], b.height[i], 1000.0 * d.bin[i].height,
                1000.0 * a.sd[i], 1000.0 * b.sd[i], a.q10[i], a.q90[i], b.q10[i], b.q90[i]);
        }
        say(messages_, "  moved most at {:+.1f} m, by {:.0f} mm; {} then, {} now\n",
            binCentre(d.largestBin), 1000.0 * d.largest(), words(d.before), words(d.after));
    }

    void summarise() const
    {
        std::size_t same = 0, lastBits = 0, other = 0;
        std::vector<double> moved;
        for (const Rerun& r : reruns_) {
            same += r.differences.likeness == Match::Identical;
            lastBits += r.differences.likeness == Match::LastBits;
            other += r.differences.before.stepVerdict != r.differences.after.stepVerdict;
            moved.push_back(r.differences.largest());
        }
        std::sort(moved.begin(), moved.end());
        say(messages_,
            "\n{} estimates of {} sessions: {} the same bit for bit, {} but for the "
            "last bits, {} with another verdict; largest move of a bin {:.0f} mm in the "
            "median estimate, {:.0f} mm in the worst\n",
            reruns_.size(), sessionsOf(reruns_), same, lastBits, other,
            1000.0 * moved[moved.size() / 2], 1000.0 * moved.back());
    }

    void printRow(std::string_view label, const ErrorStatistics& s) const
    {
        say(messages_, "  {:<5} {:6} {:13.1f} {:10.1f} {:14.0f}\n", label, s.n, 1000.0 * s.median,
            1000.0 * s.crps, 100.0 * s.coverage);
    }

    /// Prints scores against the truth, if a simulated source recorded it.
    void printScores() const
    {
        std::vector<BinError> then, now;
        for (std::size_t k = 0; k < reruns_.size(); ++k) {
            const Scene scene = evaluated(*reruns_[k].session->scene(reruns_[k].row.scene));
            for (const BinError& e : binErrors(k, scene, "then", reruns_[k].row.estimate))
                then.push_back(e);
            for (const BinError& e : binErrors(k, scene, "now", reruns_[k].again)) now.push_back(e);
        }
        if (then.empty()) return;
        say(messages_,
            "\nagainst the truth, which the source knew\n         bins  |error| [mm]  CRPS "
            "[mm]  in 80 % band\n");
        printRow("then", statistics(then));
        printRow("now", statistics(now));
    }

    /// Calibration of the recorded and recomputed bands against later measurements.
    struct Ledgers {
        CalibrationLedger then, now;
    };

    /// Returns the calibration against later probes of the same scene.
    Ledgers laterProbes(const SessionReader& session) const
    {
        Ledgers ledgers;
        for (const Rerun& later : reruns_) {
            if (later.session != &session || later.row.role == EstimateRole::Second) continue;
            const Rerun* before = nullptr;
            for (const Rerun& r : reruns_)
                if (r.session == &session && r.row.scene == later.row.scene
                    && r.row.id < later.row.id && r.row.readings.size() < later.row.readings.size())
                    before = &r;
            if (!before) continue;
            for (std::size_t k = before->row.readings.size(); k < later.row.readings.size(); ++k) {
                const ArmReading& reading = later.row.readings[k];
                ledgers.then.record(before->row.estimate, reading.bin, reading.height, reading.sd,
                                    Origin::Arm);
                ledgers.now.record(before->again, reading.bin, reading.height, reading.sd,
                                   Origin::Arm);
            }
        }
        return ledgers;
    }

    /// Returns the calibration against contacts and probes at later poses. It uses the last estimate of each scene from
    /// which odometry is continuous.
    Ledgers laterPosesOf(SessionReader& session) const
    {
        std::map<std::int64_t, const Rerun*> last;  // last rerun of each scene
        for (const Rerun& r : reruns_)
            if (r.session == &session && r.row.role != EstimateRole::Second) last[r.row.scene] = &r;
        std::vector<const Rerun*> ofScene;
        std::vector<EstimateOfScene> estimates;  // recorded and recomputed estimates alternate
        for (std::size_t scene = 0; scene < session.scenes().size(); ++scene) {
            const auto found = last.find(session.scenes()[scene].id);
            ofScene.push_back(found == last.end() ? nullptr : found->second);
            if (!ofScene.back()) continue;
            estimates.push_back({scene, &ofScene.back()->row.estimate});
            estimates.push_back({scene, &ofScene.back()->again});
        }
        Ledgers ledgers;
        const auto robot = robotOf(session);
        if (!robot || ofScene.size() < 2) return ledgers;
        for (const LaterPose& pose : laterPoses(session, *robot, estimates)) {
            if (!ofScene[pose.scene]) continue;
            CalibrationLedger& ledger = pose.estimate % 2 == 0 ? ledgers.then : ledgers.now;
            ledger.record(*estimates[pose.estimate].estimate, pose.ghost,
                          ofScene[pose.scene]->row.estimate);
        }
        return ledgers;
    }

    /// Prints one line per session, sorted by name and thus by time, and one line for all.
    void printLedger(std::string_view title,
                     const std::function<Ledgers(SessionReader&)>& ledgersOf) const
    {
        Ledgers all;
        std::string lines;
        std::size_t sessions = 0;
        for (const auto& session : sessions_) {
            const Ledgers ledgers = ledgersOf(*session);
            if (ledgers.then.entries().empty() && ledgers.now.entries().empty()) continue;
            all.then.add(ledgers.then);
            all.now.add(ledgers.now);
            ++sessions;
            lines += ledgerLines(ledgers, ", " + utcText(session->start().wallTime) + ", "
                                              + printable(session->path()));
        }
        if (sessions == 0) return;
        say(messages_, "\n{}\n         times  in 50 %  in 80 %  in 95 %  rms z  bands\n{}", title,
            Lines(sessions > 1 ? lines : std::string()));
        say(messages_, "{}", Lines(ledgerLines(all, sessions > 1 ? ", all" : "")));
    }

    static std::string ledgerLines(const Ledgers& ledgers, const std::string& where)
    {
        std::string lines;
        for (const auto& [label, ledger] :
             {std::pair{"then", &ledgers.then}, std::pair{"now", &ledgers.now}}) {
            const LedgerSummary s = ledger->summary();
            lines += fmt::format("  {:<5} {:6} {:8.0f} {:8.0f} {:8.0f} {:6.2f}  {}{}\n", label, s.n,
                                 100.0 * s.in50.share, 100.0 * s.in80.share, 100.0 * s.in95.share,
                                 s.rmsZ, name(s.verdict), where);
        }
        return lines;
    }

    std::string csv() const
    {
        std::string text = "file,estimate,scene,t_s,method,bin_m,height_then_m,height_now_m,"
                           "sd_then_m,sd_now_m,q10_then_m,q10_now_m,q90_then_m,q90_now_m,truth_m,"
                           "identical,verdict_then,verdict_now\n";
        for (const Rerun& r : reruns_) {
            const TerrainEstimate &a = r.row.estimate, &b = r.again;
            const SceneRow* scene = r.session->scene(r.row.scene);
            for (std::size_t i = 0; i < kBins; ++i)
                text += fmt::format(
                    "{},{},{},{},{},{:+.1f},{},{},{},{},{},{},{},{},{},{:d},{},{}\n",
                    csvField(r.session->path()), r.row.id, r.row.scene, secondsOf(r.row.time),
                    name(b.settings.method), binCentre(static_cast<int>(i)), a.height[i],
                    b.height[i], a.sd[i], b.sd[i], a.q10[i], b.q10[i], a.q90[i], b.q90[i],
                    scene->truth ? numberText(scene->truth->at(i)) : "",
                    r.differences.likeness == Match::Identical,
                    name(r.differences.before.stepVerdict), name(r.differences.after.stepVerdict));
        }
        return text;
    }

    const WhatIfOptions& options_;
    Interrupt interrupt_;
    std::FILE* const messages_ = messagesBeside(options_.out);
    Toolboxes toolboxes_;
    SceneOrigins origins_;
    std::vector<std::unique_ptr<SessionReader>> sessions_;
    std::vector<Rerun> reruns_;
};

/// Returns the sessions in a folder sorted by name; a file returns itself.
std::vector<std::string> sessionsAt(const std::string& path)
{
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored)) return {path};
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(path))
        if (entry.path().extension() == ".tts") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

Status whatIf(const WhatIfOptions& options)
{
    WhatIf again(options);
    try {
        for (const std::string& path : options.files)
            for (const std::string& file : sessionsAt(path))
                if (Status done = again.run(file); !done) return done;
    } catch (const Cancelled&) {
        return Error{"what-if was cancelled (Ctrl+C): nothing is compared and nothing is written"};
    }
    return again.conclude();
}

}  // namespace terratact
