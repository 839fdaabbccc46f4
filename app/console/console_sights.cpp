#include "app/console/console_sights.h"

#include <algorithm>
#include <array>
#include <limits>

#include "app/mission/bus_words.h"
#include "app/shell/watched_application.h"
#include "widgets/base/words.h"

namespace terratact {
namespace {

template <class T>
const T* pointer(const std::optional<T>& value)
{
    return value ? &*value : nullptr;
}

void addEstimation(TerrainSight& sight, const Estimation& estimation)
{
    if (const auto& scene = estimation.scene()) {
        sight.scene = &scene->measurement;
        sight.sceneTruth = &scene->truth;
    }
    sight.estimate = pointer(estimation.estimate());
    sight.estimateSeconds = estimation.seconds();
    sight.second = pointer(estimation.second());
    if (sight.second) sight.secondName = words::text(name(sight.second->settings.method));
    sight.live = pointer(estimation.live());
    sight.ghost = estimation.ghost();
    sight.whyNoGhost = estimation.whyNoGhost();
    sight.verdict = estimation.verdict();
}

/// Of the frames that the readout's rows come in.
RobotReadout::Ages agesOf(const BusTap& tap, double now)
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

/// [s] of the oldest of the frames that the forces come in; empty: none has arrived.
std::optional<double> forcesAgeOf(const BusTap& tap, double now)
{
    using enum FrameKind;
    std::optional<double> oldest;
    for (const FrameKind kind : {LeftForces1To3, LeftForces4To6, RightForces1To3, RightForces4To6})
        if (const auto age = tap.age(kind, now)) oldest = std::max(*age, oldest.value_or(0.0));
    return oldest;
}

}  // namespace

LinkSight ConsoleSights::link(double now, const std::optional<Received>& newest)
{
    const bool alive = parts_.exploration.linkAlive();
    LinkSight sight{.now = now, .newest = pointer(newest)};
    std::optional<double> age;
    if (newest) age = now - secondsOf(newest->arrived);
    if (parts_.link && age && !alive)
        sight.heard = stillComes(parts_.link->tap().frames(now), *age);
    sight.link = link_.look({.now = now,
                             .age = age,
                             .alive = alive,
                             .othersCome = !sight.heard.isEmpty(),
                             .ended = parts_.exploration.ended()});
    return sight;
}

Attitude ConsoleSights::attitudeOf(const Measurement& line) const
{
    AttitudeLimits limits;
    if (parts_.preferences)
        limits = {parts_.preferences->current().tiltAmber, parts_.preferences->current().tiltRed};
    return terratact::attitudeOf(line, model_, limits);
}

AlarmSight ConsoleSights::alarms(double now, const std::optional<Received>& newest,
                                 const LinkAccount& link) const
{
    const Exploration& exploration = parts_.exploration;
    AlarmSight sight{.link = link};
    if (newest) sight.suspicions = newest->suspicions;
    if (newest && exploration.linkAlive()) {
        sight.measurement = newest->sample.measurement;
        sight.attitude = attitudeOf(*sight.measurement);
    }
    sight.isSceneSuspected = exploration.estimation().wasSuspected();
    if (newest) sight.isStopped = newest->sample.measurement.activity == RobotActivity::Stopped;
    sight.sourceTrouble = troubleWords(parts_.link, parts_.acquisition.trouble());
    if (CanSource* bus = parts_.link) {
        sight.bus = bus->view();
        sight.busName = bus->busName();
        sight.wrongChecksums =
            bus->tap().load().troubles[static_cast<std::size_t>(FrameTrouble::WrongChecksum)];
    }
    sight.noModel = exploration.estimation().model().trouble;
    if (parts_.recorder) sight.notRecorded = words::sentence(parts_.recorder->state().trouble);
    if (parts_.panel && !parts_.panel->answers(now))
        sight.panelTrouble = exploration.following()  // then it stops nothing
                               ? tr("The operator's panel does not answer")
                               : tr("The operator's panel does not answer, which means STOP");
    if (exploration.state().phase == AtemPhase::Failed)
        sight.failedExploration = exploration.stateWords();
    return sight;
}

TerrainSight ConsoleSights::terrain(double now, const std::optional<Received>& newest)
{
    const Exploration& exploration = parts_.exploration;
    TerrainSight sight{.now = now, .ended = exploration.ended()};
    if (newest) {
        sight.measurement = &newest->sample.measurement;
        sight.age = now - secondsOf(newest->arrived);
        if (parts_.link && !sight.ended) {
            sight.ages = agesOf(parts_.link->tap(), now);
            sight.forcesAge = forcesAgeOf(parts_.link->tap(), now);
        }
        sight.count = newest->count;
        sight.attitude = attitudeOf(*sight.measurement);
        sight.forces = &forcesOf(*newest);
        sight.truth = &newest->sample.truth;
    }
    addEstimation(sight, exploration.estimation());
    sight.whyNoEstimate = exploration.whyNoEstimate();
    sight.state = exploration.state();
    sight.stateWords = exploration.stateWords();
    sight.time = exploration.time();
    sight.secondsInPhase = exploration.secondsInPhase();
    sight.proposal = pointer(exploration.proposal());
    if (!sight.proposal) sight.bestProbe = exploration.bestProbe();
    sight.whyNotOffered = exploration.whyNotOffered();
    sight.probingBin = exploration.probingBin();
    sight.probeSeconds = exploration.options().probeSeconds;
    // A preview takes a telemetry's time: its progress would only flicker.
    if (exploration.estimating()) sight.progress = parts_.worker.progress();
    sight.preconditions = exploration.preconditions();
    sight.driving = exploration.toDrive();
    sight.probing = exploration.toProbe();
    sight.releasing = exploration.toReleaseStop();
    if (parts_.link && !exploration.following())
        sight.arming = Preconditions::toArm(parts_.link->view());
    if (const auto says = panel(now))
        for (auto* list : {&sight.preconditions, &sight.driving, &sight.arming, &sight.probing,
                           &sight.releasing})
            if (!list->isEmpty()) *list << *says;
    return sight;
}

ConsoleFacts ConsoleSights::facts(double now, const QString& source,
                                  const QString& robotDetails) const
{
    ConsoleFacts facts{.telemetryRate = parts_.acquisition.rate(),
                       .estimating = parts_.worker.progress().has_value(),
                       .source = source,
                       .robot = QString::fromStdString(robot_),
                       .robotDetails = robotDetails,
                       .model = parts_.exploration.estimation().model(),
                       .longest = WatchedApplication::longestEvents()};
    if (const auto latest = parts_.acquisition.latest())
        facts.telemetryAge = now - secondsOf(latest->arrived);
    if (parts_.link) {
        facts.bus = busWords(parts_.link->view().bus, parts_.link->busName());
        facts.waiting = parts_.link->waiting();
    }
    if (const PanelControl* panel = parts_.panel)
        facts.panel = PanelFacts{.report = panel->report(),
                                 .answers = panel->answers(now),
                                 .presses = panel->reader().allPresses(),
                                 .stopLatencies = panel->reader().stopLatencies()};
    return facts;
}

std::optional<Precondition> ConsoleSights::panel(double now) const
{
    return parts_.panel ? std::optional(parts_.panel->precondition(now)) : std::nullopt;
}

const std::vector<ForceArray>& ConsoleSights::forcesOf(const Received& newest)
{
    if (newest.count == forcesCount_) return forces_;
    forcesCount_ = newest.count;
    const auto line = parts_.link ? parts_.link->view().line : std::nullopt;
    const double threshold = parts_.exploration.options().settings.forceThreshold;
    forces_ = forceArrays_.of(newest.sample.measurement, line, threshold);
    return forces_;
}

}  // namespace terratact
