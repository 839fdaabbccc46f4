#include "app/figures/session_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "app/figures/canvas.h"
#include "app/figures/payload_facts.h"
#include "app/figures/report_text.h"
#include "app/recording/recorded_sides.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "core/base/text.h"
#include "core/infer/estimate/provenance.h"
#include "core/infer/verdict/estimate_text.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/robot/side_plane.h"
#include "core/store/file_read.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {

namespace {

double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

std::string forcesText(const std::array<std::optional<double>, kForceElements>& forces)
{
    std::string text;
    for (const std::optional<double>& force : forces)
        text += force ? fmt::format(" {:.1f}", *force) : " --";
    return text;
}

std::string poseText(const Measurement& m, bool onePlane)
{
    std::string forces;
    if (onePlane)
        for (std::size_t e = 0; e < m.force.size(); ++e)
            forces +=
                m.missing[kFirstForceFeature + e] ? " --" : fmt::format(" {:.1f}", m.force[e]);
    else
        forces = " left" + forcesText(m.sides.left) + ", right" + forcesText(m.sides.right);
    return fmt::format("pitch {:+.1f}°, roll {:+.1f}°; flippers front {:+.1f}° {:+.1f}°, rear "
                       "{:+.1f}° {:+.1f}°; forces{} N",
                       degrees(m.pitch), degrees(m.roll), degrees(m.frontLeft),
                       degrees(m.frontRight), degrees(m.rearLeft), degrees(m.rearRight), forces);
}

using Facts = std::vector<std::pair<std::string, std::string>>;

/// Returns the verdict of each side and what both sides mean together; nothing of one plane.
Facts verdictFacts(const TwoTrackVerdict& v, double limit)
{
    if (v.onePlane) return {};
    return {{"left", stepText(v.side[0], limit)},
            {"right", stepText(v.side[1], limit)},
            {"either side", fmt::format("a step ahead of more than {:.2f} m has probability "
                                        "{:.0f} %",
                                        limit, 100.0 * v.either.p)},
            {"cross slope", crossSlopeText(v.crossSlope)}};
}

void addRows(std::vector<std::vector<std::string>>& table, const TerrainEstimate& e,
             const RecordedSide& side, bool names, bool chains)
{
    for (std::size_t i = 0; i < kBins; ++i) {
        const int bin = static_cast<int>(i);
        std::vector<std::string>& row = table.emplace_back();
        if (names) row.emplace_back(side.name);
        for (std::string& cell : std::vector<std::string>{
                 signedNumber(binCentre(bin), 1), signedNumber(e.height[i], 3),
                 fmt::format("{:.0f}", 1000.0 * e.sd[i]), signedNumber(e.q10[i], 3),
                 signedNumber(e.q90[i], 3),
                 std::isfinite(e.ceiling[i]) ? signedNumber(e.ceiling[i], 3) : "none",
                 std::string(name(provenance(e, bin))), std::string(name(e.touch[i]))})
            row.push_back(std::move(cell));
        if (chains) {
            row.push_back(rhatText(e.rhat[i]));
            row.push_back(fmt::format("{:.0f}", e.ess[i]));
        }
        if (table.front().back() == "truth [m]")
            row.push_back(side.truth ? signedNumber(side.truth->at(i), 3) : "");
    }
}

std::vector<std::vector<std::string>> tableOf(const TwoTrackEstimate& e, const SceneRow& scene)
{
    std::vector<std::vector<std::string>> table{{"bin [m]", "height [m]", "sd [mm]", "q10 [m]",
                                                 "q90 [m]", "ceiling [m]", "known by", "touch"}};
    // Only Markov chains have R-hat and effective draws.
    const bool chains = e.side[0].ending != Ending::NotSampled
                     || (!e.onePlane && e.side[1].ending != Ending::NotSampled);
    if (chains) table.front().insert(table.front().end(), {"R-hat", "ESS"});
    const std::vector<RecordedSide> sides = recordedSides(e.onePlane, &scene);
    if (!e.onePlane) table.front().insert(table.front().begin(), "side");
    if (std::ranges::any_of(sides, [](const auto& side) { return side.truth.has_value(); }))
        table.front().emplace_back("truth [m]");
    for (const RecordedSide& side : sides)
        addRows(table, e.side.at(side.index), side, !e.onePlane, chains);
    return table;
}

/// Returns the outline of the robot, in the vertical plane of a side if there are two.
Outline outlineOf(const RobotModel& robot, const Measurement& m, bool onePlane, std::size_t index)
{
    if (onePlane) {
        const Proprioception s = proprioception(m);
        return robotOutline(robot, s.pitch, s.front, s.rear);
    }
    const Side side = index == 0 ? Side::Left : Side::Right;
    const Proprioception s = sideReadings(twoTrackReadings(m), side);
    return robotOutline(inSidePlane(robot, m.roll, signOf(side) * robot.lateral.flipperY), s.pitch,
                        s.front, s.rear);
}

/// Returns the profile of one plane, or of the left and the right side. before: the estimate before
/// this one; null: none.
std::vector<FigureInput> figuresOf(const EstimateRow& row, const EstimateRow* before,
                                   const SceneRow& scene, const RobotModel& robot,
                                   const std::string& title)
{
    const bool onePlane = row.estimate.onePlane;
    std::vector<FigureInput> figures;
    for (const RecordedSide& side : recordedSides(onePlane, &scene))
        figures.push_back({.estimate = row.estimate.side.at(side.index),
                           .previous = before ? std::optional(before->estimate.side.at(side.index))
                                              : std::nullopt,
                           .outline = outlineOf(robot, scene.measurement, onePlane, side.index),
                           .truth = side.truth,
                           .title = onePlane ? title : fmt::format("{}: {}", side.name, title),
                           .proposedBin = std::nullopt});
    return figures;
}

/// Returns the warnings of an estimate, with their side if only one side has them.
std::string warningsText(const TwoTrackEstimate& e)
{
    return english(ofBothSides(e.side[0].warnings, e.side[1].warnings), "; ");
}

/// Returns the operator's actions from this scene until the next.
std::vector<std::string> eventsOf(const SessionReader& session, const SceneRow& scene)
{
    SessionTime end = session.end();
    for (const SceneRow& other : session.scenes())
        if (other.time > scene.time) end = std::min(end, other.time - 1);
    std::vector<std::string> texts;
    for (const EventRow& e : session.events()) {
        const bool operators = e.kind == EventKind::Decision || e.kind == EventKind::Marker;
        if (!operators || e.time < scene.time || e.time > end) continue;
        texts.push_back(fmt::format(
            "{} ({}) {}{}{}{}", utcText(wallTimeOf(session.start(), e.time)), momentText(e.time),
            e.subject.empty() ? "marker" : e.subject, e.text.empty() ? "" : ": " + e.text,
            e.shown.empty() ? "" : " — on the screen: ", e.shown));
    }
    return texts;
}

const SceneRow* sceneOf(const SessionReader& session, std::int64_t id)
{
    if (id != 0) return session.scene(id);
    const SceneRow* last = nullptr;
    for (const EstimateRow& estimate : session.estimates())
        if (const SceneRow* scene = session.scene(estimate.scene)) last = scene;
    return last;
}

/// Returns the scene's estimates in order, without those of a second method.
std::vector<const EstimateRow*> estimatesOf(const SessionReader& session, std::int64_t scene)
{
    std::vector<const EstimateRow*> rows;
    for (const EstimateRow& row : session.estimates())
        if (row.scene == scene && row.role != EstimateRole::Second) rows.push_back(&row);
    return rows;
}

}  // namespace

Result<SessionReport> reportOf(SessionReader& session, std::int64_t wanted,
                               const std::function<bool(double)>& progress,
                               const std::shared_ptr<const DbcBook>& book)
{
    const SceneRow* scene = sceneOf(session, wanted);
    if (!scene)
        return fileError(session.path(), wanted != 0 ? fmt::format("has no scene {}", wanted)
                                                     : "has no scene with an estimate");
    const auto rows = estimatesOf(session, scene->id);
    if (rows.empty())
        return fileError(session.path(), fmt::format("scene {} was not estimated", scene->id));
    const auto robot = robotOf(session);
    if (!robot) return robot.error();
    EstimateRow row = *rows.back();
    auto full = recordedEstimate(session, row);
    if (!full) return full.error();
    row.estimate = std::move(*full);

    const SessionStart& start = session.start();
    const ModelRow* model = session.model(row.model);
    bool goesOn = true;
    const SessionVerification found =
        session.verify([&](double share) { return goesOn = !progress || progress(share); });
    if (!goesOn) return fileError(session.path(), "no report: ended before all was read");
    SessionReport report;
    report.title = fmt::format("Scene {} of {}", scene->id,
                               std::filesystem::path(session.path()).filename().string());
    const TwoTrackVerdict verdict =
        verdictOf(row.estimate, *robot, scene->measurement, {}, row.stepLimit);
    report.verdict =
        verdict.onePlane ? stepText(verdict.side[0], row.stepLimit) : describe(verdict);
    report.figures =
        figuresOf(row, rows.size() > 1 ? rows[rows.size() - 2] : nullptr, *scene, *robot,
                  fmt::format("Estimate {}, {}", row.id, utcText(wallTimeOf(start, row.time))));
    report.table = tableOf(row.estimate, *scene);
    report.facts = {
        {"source",
         fmt::format("{}, bus {}, recorded by {}", start.source, start.bus, start.program)},
        {"captured", fmt::format("{}, {} after the session's start",
                                 utcText(wallTimeOf(start, scene->time)), momentText(scene->time))},
        {"estimated",
         fmt::format("{}, in {:.2f} s{}", momentText(row.time), row.seconds,
                     row.estimate.side[0].ending == Ending::NotSampled
                         ? ""
                         : fmt::format(", sampling ended: {}", name(row.estimate.side[0].ending)))},
        {"pose", poseText(scene->measurement, row.estimate.onePlane)},
        {"arm", readingsText(row)},
        {"settings", settingsText(row.estimate.side[0].settings)},
        {"robot", fmt::format("{}, SHA-256 {}", robot->name, start.robotHash)},
        {"model", model ? fmt::format("{}, SHA-256 {}", model->name, model->hash) : "damaged"},
        {"session",
         fmt::format("{}; last link of its chain {}",
                     found.damage.empty() && !found.broken ? "every hash holds"
                                                           : "PARTS ARE NOT WHAT WAS RECORDED",
                     found.chain)}};
    const Facts payload = payloadFacts(session, book, scene->time);
    report.facts.insert(report.facts.end(), payload.begin(), payload.end());
    const Facts verdicts = verdictFacts(verdict, row.stepLimit);
    report.facts.insert(report.facts.begin(), verdicts.begin(), verdicts.end());
    if (const std::string warnings = warningsText(row.estimate); !warnings.empty())
        report.facts.insert(report.facts.begin(), {"warnings", warnings});
    report.events = eventsOf(session, *scene);
    return report;
}

}  // namespace terratact
