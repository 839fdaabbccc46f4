#include "app/modelling/session_reruns.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "app/recording/recorded_sides.h"
#include "app/runtime/resources.h"
#include "core/base/text.h"
#include "core/log/later_poses.h"
#include "core/store/csv_text.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"

namespace terratact {
namespace {

Settings changed(Settings settings, const RerunChanges& changes)
{
    if (changes.method) settings.method = *changes.method;
    if (changes.preset) settings = withPreset(settings, *changes.preset);
    if (changes.threshold) settings.forceThreshold = *changes.threshold;
    if (changes.seed) settings.seed = *changes.seed;
    return settings;
}

Scene evaluated(const SceneRow& row, const std::optional<Heights>& truth)
{
    Scene scene{
        .run = {}, .time = secondsOf(row.time), .s = proprioception(row.measurement), .truth = {}};
    if (truth)
        for (std::size_t i = 0; i < kBins; ++i) scene.truth[i] = (*truth)[i];
    return scene;
}

/// Returns true if a reading of the arm judges the bands of that side. A reading in the middle is of
/// neither side of two.
bool judges(const ArmReading& reading, const TwoTrackEstimate& estimate)
{
    return estimate.onePlane || reading.side != ProbeSide::Middle;
}

/// Returns the CSV lines of one profile.
std::string linesOf(const Rerun& r, const RecordedSide& side)
{
    const TerrainEstimate& a = r.row.estimate.side.at(side.index);
    const TerrainEstimate& b = r.again.side.at(side.index);
    std::string text;
    for (std::size_t i = 0; i < kBins; ++i)
        text += csvLine({r.session->path(), r.row.id, r.row.scene, secondsOf(r.row.time),
                         name(b.settings.method), signedTenth(binCentre(static_cast<int>(i))),
                         a.height[i], b.height[i], a.sd[i], b.sd[i], a.q10[i], b.q10[i], a.q90[i],
                         b.q90[i], side.truth ? numberText(side.truth->at(i)) : "",
                         r.differences.match == Match::Identical, name(r.differences.before.both),
                         name(r.differences.after.both), side.name});
    return text;
}

void recordReading(CalibrationLedger& ledger, const TwoTrackEstimate& before,
                   const ArmReading& reading)
{
    if (!judges(reading, before)) return;
    ledger.record(sideOf(before, reading.side), reading.bin, reading.height, reading.sd,
                  Origin::Arm);
}

/// Returns the networks beside a model; empty: there are none.
std::string existingTrail(const std::string& modelPath)
{
    std::error_code none;
    std::string path = trailPathBeside(modelPath);
    return std::filesystem::exists(path, none) ? path : std::string();
}

/// Returns true if the networks beside the model are those of the recording.
bool hasRecordedTrail(const SessionReader& session, const EstimateRow& row,
                      const std::string& modelPath)
{
    const auto hash = sha256OfFile(trailPathBeside(modelPath));
    return hash && *hash == session.model(row.model)->trailHash;
}

/// Returns an Error if the networks of the method trail are not there. A scene without a memory needs none: local
/// estimates it.
Status requireNetworks(const SessionReader& session, const EstimateRow& row, const Models& models)
{
    if (models.trail) return Done{};
    return fileError(session.path(),
                     fmt::format("estimate {}: the method trail needs the networks that were "
                                 "recorded, {}, beside the model with the same name",
                                 row.id, shown(session.model(row.model)->trailName)));
}

}  // namespace

SessionReruns::SessionReruns(Options options, Hooks hooks)
    : options_(std::move(options)), hooks_(std::move(hooks))
{
}

Status SessionReruns::add(const std::string& file)
{
    auto session = SessionReader::open(file);
    if (!session) return session.error();
    sessions_.push_back(std::make_unique<SessionReader>(std::move(*session)));
    SessionReader& reader = *sessions_.back();
    if (hooks_.opened) hooks_.opened(reader);
    const std::set<std::int64_t> repeated = origins_.add(reader);
    bool any = false;
    for (const EstimateRow& row : reader.estimates()) {
        if (options_.estimate != 0 && row.id != options_.estimate) continue;
        any = true;
        if (repeated.contains(row.scene)) continue;
        if (Status done = repeat(reader, row); !done) return done;
    }
    if (!any && options_.estimate != 0)
        return fileError(file, fmt::format("has no estimate {}", options_.estimate));
    return Done{};
}

Result<const EstimatorBundle*> SessionReruns::bundleOf(const RobotModel& robot,
                                                       const std::string& robotText,
                                                       const std::string& path, Method method)
{
    const std::string trail = method == Method::Trail ? existingTrail(path) : std::string();
    const auto with = bundles_.find({robotText, path, existingTrail(path)});
    auto& bundle =
        with != bundles_.end() && with->second ? with->second : bundles_[{robotText, path, trail}];
    if (!bundle) {
        auto opened = openEstimatorBundle(robot, path, trail);
        if (!opened) return opened.error();
        bundle = std::move(*opened);
    }
    return static_cast<const EstimatorBundle*>(bundle.get());
}

Result<std::string> SessionReruns::modelPath(const SessionReader& session, const EstimateRow& row,
                                             bool& recordedOne) const
{
    const ModelRow* model = session.model(row.model);
    if (!model)
        return fileError(session.path(),
                         fmt::format("estimate {}: its model is not there", row.id));
    if (options_.model.empty()) {
        const auto path = modelFileOf(*model, options_.shippedModels);
        recordedOne = true;
        if (path) return *path;
        return Error{path.error().text + "; --model FILE names it or another"};
    }
    const auto hash = sha256OfFile(options_.model);
    if (!hash) return hash.error();
    recordedOne = *hash == model->hash;
    return options_.model;
}

Status SessionReruns::repeat(SessionReader& session, const EstimateRow& row)
{
    const auto robot = robotOf(session);
    if (!robot) return robot.error();
    bool recordedModel = false;
    const auto path = modelPath(session, row, recordedModel);
    if (!path) return path.error();
    const Settings settings = changed(row.estimate.side[0].settings, options_.changes);
    const auto bundle = bundleOf(*robot, session.start().robot, *path, settings.method);
    if (!bundle) return bundle.error();
    auto before = recordedEstimate(session, row);
    if (!before) return before.error();
    const Watch watch = hooks_.watch ? hooks_.watch(row) : Watch{};
    if (watch.cancelled && watch.cancelled()) throw Cancelled{};
    if (settings.method == Method::Trail) {
        if (const Status fits = requireNetworks(session, row, (*bundle)->models); !fits)
            return fits.error();
        recordedModel = recordedModel && hasRecordedTrail(session, row, *path);
    }
    auto again = estimateAgain(session, row, (*bundle)->models, settings, watch);
    if (!again) return again.error();
    Rerun rerun{.session = &session, .row = row, .again = std::move(*again), .differences = {}};
    rerun.row.estimate = std::move(*before);
    rerun.asRecorded = recordedModel && settings == row.estimate.side[0].settings;
    rerun.differences = differencesBetween(rerun.row.estimate, rerun.again, *robot,
                                           session.scene(row.scene)->measurement, row.stepLimit);
    reruns_.push_back(std::move(rerun));
    return Done{};
}

std::size_t SessionReruns::sessionsWithReruns() const
{
    std::set<const SessionReader*> sessions;
    for (const Rerun& rerun : reruns_) sessions.insert(rerun.session);
    return sessions.size();
}

std::size_t SessionReruns::failed() const
{
    return static_cast<std::size_t>(
        std::ranges::count_if(reruns_, [](const Rerun& rerun) { return rerun.failed(); }));
}

RerunErrors SessionReruns::errors() const
{
    RerunErrors errors;
    for (std::size_t k = 0; k < reruns_.size(); ++k) {
        const Rerun& rerun = reruns_[k];
        const SceneRow& row = *rerun.session->scene(rerun.row.scene);
        for (const RecordedSide& side : recordedSides(rerun.differences.onePlane, &row)) {
            const Scene scene = evaluated(row, side.truth);
            for (const BinError& e :
                 binErrors(k, scene, "then", rerun.row.estimate.side.at(side.index)))
                errors.then.push_back(e);
            for (const BinError& e : binErrors(k, scene, "now", rerun.again.side.at(side.index)))
                errors.now.push_back(e);
        }
    }
    return errors;
}

RerunLedgers SessionReruns::laterProbes(const SessionReader& session) const
{
    RerunLedgers ledgers;
    for (const Rerun& later : reruns_) {
        if (later.session != &session || later.row.role == EstimateRole::Second) continue;
        const Rerun* before = nullptr;
        for (const Rerun& r : reruns_)
            if (r.session == &session && r.row.scene == later.row.scene && r.row.id < later.row.id
                && r.row.readings.size() < later.row.readings.size())
                before = &r;
        if (!before) continue;
        for (std::size_t k = before->row.readings.size(); k < later.row.readings.size(); ++k) {
            const ArmReading& reading = later.row.readings[k];
            recordReading(ledgers.then, before->row.estimate, reading);
            recordReading(ledgers.now, before->again, reading);
        }
    }
    return ledgers;
}

RerunLedgers SessionReruns::laterPoses(SessionReader& session) const
{
    std::map<std::int64_t, const Rerun*> last;  // last rerun of each scene
    for (const Rerun& r : reruns_)
        if (r.session == &session && r.row.role != EstimateRole::Second) last[r.row.scene] = &r;
    std::vector<const Rerun*> ofScene;
    // Of each scene: left and right as recorded, then left and right as recomputed.
    std::vector<EstimateOfScene> estimates;
    std::vector<const Rerun*> ofEstimate;
    for (std::size_t scene = 0; scene < session.scenes().size(); ++scene) {
        const auto found = last.find(session.scenes()[scene].id);
        ofScene.push_back(found == last.end() ? nullptr : found->second);
        if (!ofScene.back()) continue;
        for (const TwoTrackEstimate* estimate :
             {&ofScene.back()->row.estimate, &ofScene.back()->again})
            for (const TerrainEstimate& side : estimate->side) {
                estimates.push_back({scene, &side});
                ofEstimate.push_back(ofScene.back());
            }
    }
    RerunLedgers ledgers;
    const auto robot = robotOf(session);
    if (!robot || ofScene.size() < 2) return ledgers;
    for (const LaterPose& pose : terratact::laterPoses(session, *robot, estimates)) {
        const Rerun* const later = ofScene[pose.scene];
        if (!later) continue;
        const std::size_t side = pose.estimate % 2;
        const bool now = pose.estimate % 4 >= 2;
        const Rerun& earlier = *ofEstimate[pose.estimate];
        const bool onePlane =
            (now ? earlier.again : earlier.row.estimate).onePlane && later->row.estimate.onePlane;
        if (onePlane && side == 1) continue;
        (now ? ledgers.now : ledgers.then)
            .record(*estimates[pose.estimate].estimate, pose.carried,
                    later->row.estimate.side.at(side));
    }
    return ledgers;
}

std::string SessionReruns::csv() const
{
    std::string text = "file,estimate,scene,t_s,method,bin_m,height_then_m,height_now_m,"
                       "sd_then_m,sd_now_m,q10_then_m,q10_now_m,q90_then_m,q90_now_m,truth_m,"
                       "identical,verdict_then,verdict_now,side\n";
    for (const Rerun& r : reruns_)
        for (const RecordedSide& side :
             recordedSides(r.differences.onePlane, r.session->scene(r.row.scene)))
            text += linesOf(r, side);
    return text;
}

std::vector<std::string> sessionsAt(const std::string& path)
{
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored)) return {path};
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(path))
        if (entry.path().extension() == ".tts" && !entry.is_directory(ignored))
            files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace terratact
