#include "app/figures/report/session_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "app/figures/canvas.h"
#include "app/figures/report/payload_facts.h"
#include "app/figures/report/report_text.h"
#include "app/recording/recorded_sides.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "core/base/text.h"
#include "core/infer/estimate/provenance.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/log/event_text.h"
#include "core/robot/side_plane.h"
#include "core/store/file_read.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {

namespace {

constexpr SourceText kHashed{"", "%1, SHA-256 %2"};

double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

std::string forcesText(const std::array<std::optional<double>, kForceElements>& forces)
{
    std::string text;
    for (const std::optional<double>& force : forces)
        text.append(text.empty() ? "" : " ").append(force ? fixed(*force, 1) : "--");
    return text;
}

Message allForcesText(const Measurement& m, bool onePlane)
{
    if (!onePlane)
        return {TR_NOOP("Report", "left %1, right %2"), forcesText(m.sides.left),
                forcesText(m.sides.right)};
    std::array<std::optional<double>, kForceElements> known;
    for (std::size_t e = 0; e < known.size(); ++e)
        if (!m.missing[kFirstForceFeature + e]) known[e] = m.force[e];
    return Message::verbatim(forcesText(known));
}

Message poseText(const Measurement& m, bool onePlane)
{
    const auto angle = [](double radians) { return signedFixed(degrees(radians), 1); };
    return {TR_NOOP("Report", "pitch %1°, roll %2°; flippers front %3° %4°, rear %5° %6°; forces "
                              "%7 N"),
            angle(m.pitch),
            angle(m.roll),
            angle(m.frontLeft),
            angle(m.frontRight),
            angle(m.rearLeft),
            angle(m.rearRight),
            allForcesText(m, onePlane)};
}

using Facts = std::vector<std::pair<std::string, std::string>>;

/// Returns the verdict of each side and what both sides mean together; nothing of one plane.
Facts verdictFacts(const TwoTrackVerdict& v, double limit, const Wording& wording)
{
    if (v.onePlane) return {};
    return {
        {wording(TR_NOOP("Report", "left")), wording(stepText(v.side[0], limit))},
        {wording(TR_NOOP("Report", "right")), wording(stepText(v.side[1], limit))},
        {wording(TR_NOOP("Report", "either side")),
         wording({v.both == StepVerdict::Clear
                      ? TR_NOOP("Report",
                                "a step of more than %1 m up to each horizon has probability %2 %")
                      : TR_NOOP("Report", "a step ahead of more than %1 m has probability %2 %"),
                  fixed(limit, 2), fixed(100.0 * answeredBy(v).p, 0)})},
        {wording(TR_NOOP("Report", "cross slope")), wording(crossSlopeText(v.crossSlope))}};
}

void addRows(std::vector<std::vector<std::string>>& table, const TerrainEstimate& e,
             const RecordedSide& side, bool names, bool chains, const Wording& wording)
{
    for (std::size_t i = 0; i < kBins; ++i) {
        const int bin = static_cast<int>(i);
        std::vector<std::string>& row = table.emplace_back();
        if (names) row.push_back(wording(tableWord(side.name)));
        for (std::string& cell : std::vector<std::string>{
                 signedNumber(binCentre(bin), 1), signedNumber(e.height[i], 3),
                 fmt::format("{:.0f}", 1000.0 * e.sd[i]), signedNumber(e.q10[i], 3),
                 signedNumber(e.q90[i], 3),
                 std::isfinite(e.ceiling[i]) ? signedNumber(e.ceiling[i], 3)
                                             : wording(TR_NOOP("Report", "none")),
                 wording(tableWord(name(provenance(e, bin)))),
                 wording(tableWord(name(e.touch[i])))})
            row.push_back(std::move(cell));
        if (chains) {
            row.push_back(rhatText(e.rhat[i]));
            row.push_back(fmt::format("{:.0f}", e.ess[i]));
        }
        if (row.size() < table.front().size())  // a column of the truth follows
            row.push_back(side.truth ? signedNumber(side.truth->at(i), 3) : "");
    }
}

std::vector<std::vector<std::string>> tableOf(const TwoTrackEstimate& e, const SceneRow& scene,
                                              const Wording& wording)
{
    std::vector<std::vector<std::string>> table{
        {wording(TR_NOOP("Report", "bin [m]")), wording(TR_NOOP("Report", "height [m]")), "sd [mm]",
         "q10 [m]", "q90 [m]", wording(TR_NOOP("Report", "ceiling [m]")),
         wording(TR_NOOP("Report", "known by")), wording(TR_NOOP("Report", "touch"))}};
    // Only Markov chains have R-hat and effective draws.
    const bool chains = e.side[0].ending != Ending::NotSampled
                     || (!e.onePlane && e.side[1].ending != Ending::NotSampled);
    if (chains) table.front().insert(table.front().end(), {"R-hat", "ESS"});
    const std::vector<RecordedSide> sides = recordedSides(e.onePlane, &scene);
    if (!e.onePlane)
        table.front().insert(table.front().begin(), wording(TR_NOOP("Report", "side")));
    if (std::ranges::any_of(sides, [](const auto& side) { return side.truth.has_value(); }))
        table.front().push_back(wording(TR_NOOP("Report", "truth [m]")));
    for (const RecordedSide& side : sides)
        addRows(table, e.side.at(side.index), side, !e.onePlane, chains, wording);
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
                                   const std::string& title, const Wording& wording)
{
    const bool onePlane = row.estimate.onePlane;
    std::vector<FigureInput> figures;
    for (const RecordedSide& side : recordedSides(onePlane, &scene))
        figures.push_back({.estimate = row.estimate.side.at(side.index),
                           .previous = before ? std::optional(before->estimate.side.at(side.index))
                                              : std::nullopt,
                           .outline = outlineOf(robot, scene.measurement, onePlane, side.index),
                           .truth = side.truth,
                           .title = onePlane ? title : wording(tableWord(side.name)) + ": " + title,
                           .proposedBin = std::nullopt,
                           .wording = wording});
    return figures;
}

/// Returns the warnings of an estimate, with their side if only one side has them.
Message warningsText(const TwoTrackEstimate& e)
{
    return Message::listed(ofBothSides(e.side[0].warnings, e.side[1].warnings), "; ");
}

/// Returns the operator's actions from this scene until the next.
std::vector<std::string> eventsOf(const SessionReader& session, const SceneRow& scene,
                                  const Wording& wording)
{
    SessionTime end = session.end();
    for (const SceneRow& other : session.scenes())
        if (other.time > scene.time) end = std::min(end, other.time - 1);
    std::vector<std::string> texts;
    for (const EventRow& e : session.events()) {
        const bool operators = e.kind == EventKind::Decision || e.kind == EventKind::Marker;
        if (!operators || e.time < scene.time || e.time > end) continue;
        std::string text = fmt::format("{} ({}) {}", utcText(wallTimeOf(session.start(), e.time)),
                                       momentText(e.time), wording(subjectMessage(e)));
        if (!e.text.empty()) text += ": " + wording(textMessage(e));
        if (!e.shown.empty())
            text += " — " + wording({TR_NOOP("Report", "on the screen: %1"), screenOf(e)});
        texts.push_back(std::move(text));
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
                               const std::shared_ptr<const DbcBook>& book, const Wording& wording)
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
    report.wording = wording;
    report.title = wording({TR_NOOP("Report", "Scene %1 of %2"), scene->id,
                            std::filesystem::path(session.path()).filename().string()});
    const TwoTrackVerdict verdict =
        verdictOf(row.estimate, *robot, scene->measurement, {}, row.stepLimit);
    report.verdict =
        wording(verdict.onePlane ? stepText(verdict.side[0], row.stepLimit) : messageOf(verdict));
    report.figures =
        figuresOf(row, rows.size() > 1 ? rows[rows.size() - 2] : nullptr, *scene, *robot,
                  wording({TR_NOOP("Report", "Estimate %1, %2"), row.id,
                           utcText(wallTimeOf(start, row.time))}),
                  wording);
    report.table = tableOf(row.estimate, *scene, wording);
    const TerrainEstimate& first = row.estimate.side[0];
    const std::vector<std::pair<SourceText, Message>> facts{
        {TR_NOOP("Report", "source"),
         {TR_NOOP("Report", "%1, bus %2, recorded by %3"), sourceMessage(start.source), start.bus,
          start.program}},
        {TR_NOOP("Report", "captured"),
         {TR_NOOP("Report", "%1, %2 after the session's start"),
          utcText(wallTimeOf(start, scene->time)), momentText(scene->time)}},
        {TR_NOOP("Report", "estimated"),
         first.ending == Ending::NotSampled
             ? Message(TR_NOOP("Report", "%1, in %2 s"), momentText(row.time),
                       fixed(row.seconds, 2))
             : Message(TR_NOOP("Report", "%1, in %2 s, sampling ended: %3"), momentText(row.time),
                       fixed(row.seconds, 2), tableWord(name(first.ending)))},
        {TR_NOOP("Report", "pose"), poseText(scene->measurement, row.estimate.onePlane)},
        {TR_NOOP("Report", "arm"), readingsText(row)},
        {TR_NOOP("Report", "settings"), settingsText(first.settings)},
        {TR_NOOP("Report", "robot"), {kHashed, robot->name, start.robotHash}},
        {TR_NOOP("Report", "model"), model ? Message(kHashed, model->name, model->hash)
                                           : Message(TR_NOOP("Report", "damaged"))},
        {TR_NOOP("Report", "session"),
         {TR_NOOP("Report", "%1; last link of its chain %2"),
          found.damage.empty() && !found.broken
              ? TR_NOOP("Report", "every hash holds")
              : TR_NOOP("Report", "PARTS ARE NOT WHAT WAS RECORDED"),
          found.chain}}};
    for (const auto& [what, text] : facts) report.facts.emplace_back(wording(what), wording(text));
    const Facts payload = payloadFacts(session, book, scene->time, wording);
    report.facts.insert(report.facts.end(), payload.begin(), payload.end());
    const Facts verdicts = verdictFacts(verdict, row.stepLimit, wording);
    report.facts.insert(report.facts.begin(), verdicts.begin(), verdicts.end());
    if (const Message warnings = warningsText(row.estimate); !warnings.empty())
        report.facts.insert(report.facts.begin(),
                            {wording(TR_NOOP("Report", "warnings")), wording(warnings)});
    report.events = eventsOf(session, *scene, wording);
    return report;
}

}  // namespace terratact
