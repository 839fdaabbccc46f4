#include "app/console/live_view_state.h"

#include <algorithm>
#include <array>
#include <limits>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/memory_text.h"
#include "app/mission/text/bus_text.h"

namespace terratact {
namespace {

template <class T>
const T* pointer(const std::optional<T>& value)
{
    return value ? &*value : nullptr;
}

void addEstimation(TerrainViewState& viewState, const Estimation& estimation)
{
    if (const auto& scene = estimation.scene()) {
        viewState.scene = &scene->measurement;
        viewState.sceneTruth = &scene->truth;
        viewState.sceneSideTruth = &scene->sideTruth;
    }
    const Estimation::Revisions revisions = estimation.revisions();
    viewState.estimate = {pointer(estimation.estimate()), revisions.estimate};
    viewState.estimateSeconds = estimation.seconds();
    if (viewState.estimate)
        viewState.memoryText =
            translated(withLedger(estimation.memoryText(), estimation.strip().ledger()));
    viewState.second = {pointer(estimation.second()), revisions.second};
    if (viewState.second)
        viewState.secondName = format::text(name(viewState.second->side[0].settings.method));
    viewState.live = {pointer(estimation.live()), revisions.live};
    viewState.remembered = estimation.remembered();
    viewState.earlier = estimation.strip().earlier();
    viewState.whyNothingRemembered =
        translated(estimation.whyNothingRemembered().value_or(Message()));
    viewState.verdict = estimation.verdict();
}

/// Returns the ages of the frames that carry the readout's rows.
RobotReadout::Ages agesOf(const FrameHistory& tap, double now)
{
    using enum FrameKind;
    RobotReadout::Ages ages{};
    constexpr std::array kFrames{Attitude,   Attitude,      FrontAngles,
                                 RearAngles, FrontCurrents, RearCurrents};
    static_assert(kFrames.size() == RobotReadout::kRows);
    for (std::size_t row = 0; row < ages.size(); ++row)
        ages[row] = tap.age(kFrames[row], now).value_or(std::numeric_limits<double>::infinity());
    return ages;
}

/// Returns the age [s] of the oldest frame that carries forces; empty: one was never received.
std::optional<double> forcesAgeOf(const FrameHistory& tap, double now)
{
    using enum FrameKind;
    std::optional<double> oldest;
    for (const FrameKind kind : {LeftForces1To3, LeftForces4To6, RightForces1To3, RightForces4To6})
        if (const auto age = tap.age(kind, now)) oldest = std::max(*age, oldest.value_or(0.0));
    return oldest;
}

}  // namespace

LinkViewState LiveViewState::link(const RobotMoment& moment)
{
    const double now = moment.now;
    const std::optional<Received>& newest = moment.latest;
    const bool alive = parts_.exploration.linkAlive();
    LinkViewState viewState{.now = now, .bus = pointer(moment.bus), .newest = pointer(newest)};
    std::optional<double> age;
    if (newest) age = now - secondsOf(newest->arrived);
    if (parts_.link && age && !alive)
        viewState.otherFrames = stillComes(parts_.link->tap().frames(now), *age);
    viewState.link = link_.poll({.now = now,
                                 .age = age,
                                 .alive = alive,
                                 .othersCome = !viewState.otherFrames.isEmpty(),
                                 .ended = parts_.exploration.ended()});
    return viewState;
}

Attitude LiveViewState::attitudeOf(const Measurement& line) const
{
    const AttitudeLimits limits =
        parts_.preferences ? parts_.preferences->current().tilt() : AttitudeLimits{};
    return terratact::attitudeOf(line, model_, limits);
}

AlarmViewState LiveViewState::alarms(const RobotMoment& moment, const LinkAccount& link) const
{
    const double now = moment.now;
    const std::optional<Received>& newest = moment.latest;
    const Exploration& exploration = parts_.exploration;
    AlarmViewState viewState{.link = link};
    if (newest) viewState.suspicions = newest->suspicions;
    if (newest && exploration.linkAlive()) {
        viewState.measurement = newest->sample.measurement;
        viewState.attitude = attitudeOf(*viewState.measurement);
    }
    viewState.isSceneSuspected = exploration.estimation().wasSuspected();
    if (newest) viewState.isStopped = newest->sample.measurement.activity == RobotActivity::Stopped;
    viewState.sourceTrouble = troubleOf(pointer(moment.bus), parts_.acquisition.trouble());
    viewState.bus = moment.bus;
    if (CanSource* bus = parts_.link)
        viewState.wrongChecksums =
            bus->tap().load().troubles[static_cast<std::size_t>(FrameTrouble::WrongChecksum)];
    viewState.noModel = exploration.estimation().model().trouble;
    if (parts_.recorder) viewState.notRecorded = parts_.recorder->state().trouble;
    if (parts_.panel && !parts_.panel->answers(now))
        viewState.panelTrouble =
            exploration.following()  // a following console stops nothing
                ? TR_NOOP("LiveViewState", "The operator's panel does not answer")
                : TR_NOOP("LiveViewState",
                          "The operator's panel does not answer: STOP is asserted");
    if (exploration.state().phase == AtemPhase::Failed)
        viewState.failedExploration = exploration.stateText();
    return viewState;
}

TerrainViewState LiveViewState::terrain(const RobotMoment& moment)
{
    const double now = moment.now;
    const std::optional<Received>& newest = moment.latest;
    const Exploration& exploration = parts_.exploration;
    TerrainViewState viewState{.now = now, .ended = exploration.ended()};
    if (newest) {
        viewState.measurement = &newest->sample.measurement;
        viewState.age = now - secondsOf(newest->arrived);
        if (parts_.link && !viewState.ended) {
            viewState.ages = agesOf(parts_.link->tap(), now);
            viewState.forcesAge = forcesAgeOf(parts_.link->tap(), now);
        }
        viewState.count = newest->count;
        viewState.attitude = attitudeOf(*viewState.measurement);
        viewState.forces = &forcesOf(*newest);
        viewState.truth = &newest->sample.truth;
    }
    addEstimation(viewState, exploration.estimation());
    viewState.whyNoEstimate = translated(exploration.whyNoEstimate());
    viewState.state = exploration.state();
    viewState.stateText = translated(exploration.stateText());
    viewState.time = exploration.time();
    viewState.secondsInPhase = exploration.secondsInPhase();
    viewState.proposal = pointer(exploration.proposal());
    if (!viewState.proposal) viewState.bestProbe = exploration.bestProbe();
    if (!viewState.proposal && !viewState.bestProbe)
        viewState.whyNoBestProbe = translated(exploration.whyNoBestProbe());
    viewState.whyNotOffered = translated(exploration.whyNotOffered().value_or(Message()));
    viewState.probingPlace = exploration.probingPlace();
    viewState.probeSeconds = exploration.options().probeSeconds;
    // A preview takes one telemetry period, so its progress would only flicker.
    if (exploration.estimating()) viewState.progress = parts_.worker.progress();
    viewState.preconditions = exploration.preconditions();
    viewState.driving = exploration.toDrive();
    viewState.feeling = exploration.toFeelForward();
    viewState.probing = exploration.toProbe();
    viewState.releasing = exploration.toReleaseStop();
    if (moment.bus && !exploration.following())
        viewState.arming = Preconditions::toArm(*moment.bus);
    if (const auto says = panel(now))
        for (auto* list : {&viewState.preconditions, &viewState.driving, &viewState.feeling,
                           &viewState.arming, &viewState.probing, &viewState.releasing})
            if (!list->isEmpty()) *list << *says;
    return viewState;
}

ConsoleFacts LiveViewState::facts(const RobotMoment& moment, const QString& source,
                                  const QString& robotDetails) const
{
    const double now = moment.now;
    ConsoleFacts facts{.telemetryRate = parts_.acquisition.rate(),
                       .estimating = parts_.worker.progress().has_value(),
                       .estimates = parts_.exploration.estimation().counts(),
                       .source = source,
                       .robot = format::shownName(robot_),
                       .robotDetails = robotDetails,
                       .model = parts_.exploration.estimation().model()};
    if (moment.latest) facts.telemetryAge = now - secondsOf(moment.latest->arrived);
    if (moment.bus) facts.bus = busStateText(moment.bus->bus, moment.bus->busName);
    if (parts_.link) facts.waiting = parts_.link->waiting();
    if (const PanelControl* panel = parts_.panel)
        facts.panel = PanelFacts{.report = panel->report(),
                                 .answers = panel->answers(now),
                                 .presses = panel->reader().allPresses(),
                                 .stopLatencies = panel->reader().stopLatencies()};
    return facts;
}

std::optional<Precondition> LiveViewState::panel(double now) const
{
    return parts_.panel ? std::optional(parts_.panel->precondition(now)) : std::nullopt;
}

const std::vector<ForceArray>& LiveViewState::forcesOf(const Received& newest)
{
    if (newest.count == forcesCount_) return forces_;
    forcesCount_ = newest.count;
    const double threshold = parts_.exploration.options().settings.forceThreshold;
    forces_ = forceArrays_.of(newest.sample.measurement, newest.sample.forces, threshold);
    return forces_;
}

}  // namespace terratact
