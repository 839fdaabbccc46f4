#include "app/exploration.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/bus_words.h"
#include "core/atem/probe_grounds.h"
#include "core/infer/estimate_words.h"
#include "widgets/words.h"

namespace terratact {
namespace {

// A pose counts as changed beyond these: five standard deviations of an MTi's difference of two pitches.
constexpr double kPitchChange = 0.06;    // [rad]
constexpr double kFlipperChange = 0.05;  // [rad]
constexpr double kRepeatStop = 0.2;      // [s]
constexpr double kReleaseFor = 5.0;      // [s] a release of STOP is tried
constexpr int kLiveDraws = 200;          // enough for what a glance asks of a preview

}  // namespace

Exploration::Exploration(MeasurementSource& source, RobotModel robot, EstimatorWorker& worker,
                         const Options& options, CanSource* link)
    : source_(source), link_(link), robot_(std::move(robot)), worker_(worker), options_(options),
      whyFollowing_(whyFollowing(link))
{
    state_.followed = following();
    connect(&worker_, &EstimatorWorker::modelLoaded, this,
            [this](const QString& name, const QString& details) {
                modelName_ = name;
                modelDetails_ = details;
                modelTrouble_.clear();
                // What is shown rests on the model before.
                if (estimate_ && !exploring(state_.phase)) pending_.aborted = true;
                if (!estimate_) track_.reset();
                emit happened(tr("model %1 loaded").arg(name), Weight::Note);
            });
    connect(&worker_, &EstimatorWorker::modelFailed, this, [this](const QString& why) {
        modelTrouble_ = why;
        emit happened(why, Weight::Bad);
    });
    connect(&worker_, &EstimatorWorker::modelKept, this, [this](const QString& why) {
        emit happened(tr("model %1 stays in use: %2").arg(modelName_, why), Weight::Bad);
    });
    connect(&worker_, &EstimatorWorker::estimated, this,
            [this](int job, const TerrainEstimate& estimate, double seconds,
                   const ProbeAdvice& advice) {
                if (job == liveJob_) takeLive(estimate);
                if (job == secondJob_) {
                    second_ = estimate;
                    emit stands(true);
                }
                if (job != job_) return;
                live_.reset();
                estimate_ = estimate;
                estimateSeconds_ = seconds;
                if (scene_) track_.emplace(robot_, estimate, scene_->measurement);
                advice_ = advice;
                pending_.estimateReady = true;
                pending_.probeWanted = advice.bin.has_value();
                proposal_.reset();
                if (advice.bin && !following()) {
                    proposal_ = proposalFor(*advice.bin);
                    proposal_->id = ++lastProposal_;
                    proposedOn_ = grounds();
                }
                emit stands(false);
                startSecond();
                emit happened(tr("estimate in %1 s").arg(words::number(seconds, 2)), Weight::Note);
                for (const std::string& warning : estimate.warnings)
                    emit happened(words::sentence(warning), Weight::Doubt);
                for (const std::string& sentence : hiddenByBands(estimate))
                    emit happened(words::sentence(sentence), Weight::Note);
            });
    connect(&worker_, &EstimatorWorker::failed, this, [this](int job, const QString& why) {
        if (job == liveJob_) {
            liveJob_ = 0;
            live_.reset();
            whyNoEstimate_ = tr("No live estimate: %1").arg(why);
        }
        if (job == secondJob_) emit happened(tr("no second estimate: %1").arg(why), Weight::Doubt);
        if (job != job_) return;
        pending_.estimateFailed = true;
        emit happened(tr("estimate failed: %1").arg(why), Weight::Bad);
    });
}

QString Exploration::nothingYet() const
{
    if (!linkAlive_ && !ended_) return tr("No estimate yet: nothing is heard of the robot");
    if (!modelTrouble_.isEmpty()) return tr("No estimate: there is no model");
    if (modelName_.isEmpty()) return tr("No estimate yet: the model is being loaded");
    if (following()) return tr("No estimate yet: it comes when the robot presses its flippers");
    if (!armed()) return tr("No estimate yet: press M, then hold M to arm; then explore (A)");
    return tr("No estimate yet: explore the terrain (A)");
}

QString Exploration::whyMoved() const
{
    return following() ? tr("The robot has moved: the next press brings the next estimate")
                       : tr("The robot has moved: explore again (A)");
}

void Exploration::request()
{
    if (following()) return;
    emit decided("explore", {});
    pending_.requested = true;
    driving_ = false;  // the halt comes from the exploration
}

void Exploration::abort()
{
    emit decided("abort", {});
    pending_.aborted = true;
}

void Exploration::approve(quint64 proposal)
{
    if (!proposal_ || proposal_->id != proposal) return;
    emit decided("approve", words::binName(proposal_->bin));
    pending_.approved = true;
    pending_.approvedFor = proposedOn_;
    approvedAt_ = now_;
}

void Exploration::refuse(quint64 proposal)
{
    if (!proposal_ || proposal_->id != proposal) return;
    emit decided("refuse", words::binName(proposal_->bin));
    pending_.refused = true;
}

void Exploration::choose(quint64 proposal, int bin)
{
    const auto& ranked = advice_.gains;
    if (!proposal_ || proposal_->id != proposal
        || std::none_of(ranked.begin(), ranked.end(),
                        [bin](const ProbeGain& gain) { return gain.bin == bin; }))
        return;
    emit decided("choose", words::binName(bin));
    proposal_ = proposalFor(bin);
    proposal_->id = ++lastProposal_;
    proposedOn_ = grounds();
    emit proposed();
    emit happened(tr("probe asked for at %1 instead").arg(words::binName(bin)), Weight::Note);
}

ProbeProposal Exploration::proposalFor(int bin) const
{
    const auto i = static_cast<std::size_t>(bin);
    ProbeProposal proposal{.id = 0,
                           .bin = bin,
                           .height = estimate_->height[i],
                           .q10 = estimate_->q10[i],
                           .q90 = estimate_->q90[i],
                           .sd = estimate_->sd[i],
                           .limit = estimate_->settings.probeAbove,
                           .armSd = robot_.armSd,
                           .seconds = options_.probeSeconds,
                           .stepLimit = advice_.stepLimit,
                           .bitsBefore = advice_.before.entropy / std::numbers::ln2,
                           .worth = {},
                           .others = {}};
    for (const ProbeGain& gain : advice_.gains) {
        const ProbeWorth worth{
            gain.bin, std::clamp(gain.varianceReduction / advice_.before.variance, 0.0, 1.0),
            std::max(0.0, advice_.before.entropy - gain.entropyReduction) / std::numbers::ln2};
        if (gain.bin == bin)
            proposal.worth = worth;
        else
            proposal.others.push_back(worth);
    }
    return proposal;
}

void Exploration::setStepLimit(double metres)
{
    if (metres == options_.stepLimit) return;
    emit decided("limit", words::number(metres, 2));
    options_.stepLimit = metres;
}

void Exploration::setSecondMethod(std::optional<Method> method)
{
    secondMethod_ = method;
    second_.reset();
    secondJob_ = 0;
    startSecond();
}

std::optional<Verdict> Exploration::verdict() const
{
    if (!estimate_ || !scene_) return std::nullopt;
    return verdictOf(*estimate_, scene_->measurement, linkAlive_, options_.stepLimit);
}

void Exploration::drive(int direction)
{
    if (!whyNotDriving().isEmpty()) return;
    driving_ = true;
    emit decided("drive", direction > 0 ? QStringLiteral("forward") : QStringLiteral("back"));
    command(DriveCommand{.speed = direction * options_.driveSpeed});
}

void Exploration::halt()
{
    if (!std::exchange(driving_, false)) return;
    emit decided("halt", {});
    command(HaltCommand{});
}

void Exploration::stop()
{
    if (following()) {
        emit happened(tr("STOP not sent: %1").arg(whyFollowing_), Weight::Bad);
        return;  // nothing is stopped, so nothing must look so
    }
    emit decided("stop", {});
    command(StopCommand{});
    stopSent_ = now_;
    pending_.stop = true;
    releasing_ = false;
    driving_ = false;
}

void Exploration::releaseStop()
{
    if (state_.phase != AtemPhase::Stopped || following()) return;
    emit decided("release stop", {});
    releasing_ = true;
    releaseBegan_ = stopSent_ = now_;
    command(ReleaseStopCommand{});
    emit happened(tr("STOP released by the operator"), Weight::Doubt);
}

void Exploration::setSettings(const Settings& settings)
{
    const std::uint64_t seed = options_.settings.seed;
    options_.settings = settings;
    options_.settings.seed = seed;
    emit decided("settings", words::text(name(settings.method)));
    emit happened(tr("the next estimate: %1, %2 draws, contacts above %3 N")
                      .arg(words::text(name(settings.method)))
                      .arg(settings.draws)
                      .arg(words::number(settings.forceThreshold, 1)),
                  Weight::Note);
}

void Exploration::leave()
{
    halt();
    if (exploring(state_.phase) && !following()) command(AbortAtemCommand{});
    if (link_) link_->disarm();
    cancelEstimate();
}

void Exploration::command(const Command& command)
{
    commandedAt_ = latest_ ? latest_->count : 0;
    const Status sent = source_.send(command);
    if (!sent)
        emit happened(tr("command not sent: %1").arg(words::sentence(sent.error().text)),
                      Weight::Bad);
}

bool Exploration::armed() const
{
    return !link_ || link_->view().link.arming.phase == ArmingPhase::Armed;
}

std::string Exploration::grounds() const
{
    if (!scene_ || !estimate_ || !proposal_) return {};
    return fingerprint({.scene = scene_->measurement,
                        .readings = readings_,
                        .settings = estimate_->settings,
                        .model = (modelName_ + modelDetails_).toStdString(),
                        .bin = proposal_->bin});
}

bool Exploration::answered() const
{
    // The next line may have been measured before the command got there; the one after was not.
    return latest_ && latest_->count >= commandedAt_ + 2;
}

bool Exploration::moved() const
{
    const Proprioception then = proprioception(scene_->measurement);
    const Measurement& m = latest_->sample.measurement;
    const Proprioception s = proprioception(m);
    return m.activity == RobotActivity::Driving || std::abs(s.pitch - then.pitch) > kPitchChange
        || std::abs(s.front - then.front) > kFlipperChange
        || std::abs(s.rear - then.rear) > kFlipperChange;
}

void Exploration::repeatStop(AtemInput& in)
{
    const bool latched = latest_->sample.measurement.activity == RobotActivity::Stopped;
    if (latched && state_.phase != AtemPhase::Stopped) in.stop = true;
    if (state_.phase != AtemPhase::Stopped) return;
    if (answered() && releasing_ && !latched) in.stopReleased = true;
    if (releasing_ && now_ - releaseBegan_ > kReleaseFor) {
        releasing_ = false;  // a word of the operator's that old is none
        emit happened(tr("the robot did not release STOP: hold R again"), Weight::Bad);
    }
    if (now_ - stopSent_ < kRepeatStop || latched != releasing_) return;
    stopSent_ = now_;
    if (releasing_)
        command(ReleaseStopCommand{});
    else
        command(StopCommand{});
}

void Exploration::lookForMoves()
{
    if (!scene_ || moved_) return;
    // Twice in a row, so that one outlier of the IMU ends nothing.
    if (!moved())
        movedAt_ = 0;
    else if (movedAt_ == 0)
        movedAt_ = latest_->count;
    else if (latest_->count > movedAt_)
        moved_ = true;
}

void Exploration::look(AtemInput& in)
{
    in.linkAlive = linkAlive_;
    if (!latest_) return;
    const Measurement& m = latest_->sample.measurement;
    repeatStop(in);
    in.poseChanged = moved_;
    if (!answered()) return;
    const bool refused = m.refusal != Refusal::None;
    switch (state_.phase) {
    case AtemPhase::Halting:
        in.halted = m.activity == RobotActivity::Halted || m.activity == RobotActivity::Pressed;
        break;
    case AtemPhase::Pressing:
        in.pressed = m.activity == RobotActivity::Pressed;
        in.pressRefused = refused || m.activity == RobotActivity::Halted;
        break;
    case AtemPhase::Probing:
        sawProbing_ = sawProbing_ || m.activity == RobotActivity::Probing;
        in.probeRefused = refused || m.activity == RobotActivity::Halted;
        in.probeDone = m.activity == RobotActivity::Pressed && m.arm && approved_
                    && m.arm->bin == approved_->bin && (sawProbing_ || m.arm != armBefore_);
        break;
    case AtemPhase::Idle:
    case AtemPhase::Estimating:
    case AtemPhase::ProposingProbe:
    case AtemPhase::EstimatingAgain:
    case AtemPhase::Presenting:
    case AtemPhase::Stopped:
    case AtemPhase::Failed: break;
    }
}

void Exploration::tick(double now, const std::optional<Received>& latest)
{
    now_ = now;
    trackGhost(latest);
    latest_ = latest;
    linkAlive_ = latest_ && now_ - secondsOf(latest_->arrived) <= options_.linkLostAfter;
    ended_ = following() && link_->view().ended;
    if (latest_) lookForMoves();
    if (following())
        follow();
    else
        advance();
    keepLive();
}

void Exploration::advance()
{
    AtemInput in = std::exchange(pending_, AtemInput{});
    in.now = now_;
    in.armed = armed();
    if (in.approved) {
        in.approvalAge = now_ - approvedAt_;
        in.grounds = grounds();
    }
    look(in);
    if (planarOverridden_ && latest_ && planarity().level == Precondition::Level::Met
        && !exploring(state_.phase)) {
        planarOverridden_ = false;
        emit happened(tr("the override has ended: left and right agree again"), Weight::Note);
    }
    if (in.aborted && !exploring(state_.phase)) {
        track_.reset();
        if (estimate_) forget(tr("No estimate: explore the terrain (A)"));
    }
    if (moved_ && estimate_) forget(whyMoved());

    const AtemState before = state_;
    state_ = nextState(state_, in, options_.limits);
    if (state_.phase != before.phase) enter(before);
}

FollowInput Exploration::followed() const
{
    const Measurement& m = latest_->sample.measurement;
    const bool captured = latest_->press && latest_->press->count == capturedPress_;
    return {.now = now_,
            .activity = m.activity,
            .linkLost = !linkAlive_ && !ended_,
            .aborted = pending_.aborted,
            .newPress = latest_->press && !captured && !modelName_.isEmpty(),
            .newReading = captured && scene_ && m.arm
                       && std::ranges::find(readings_, *m.arm) == readings_.end(),
            .poseChanged = moved_,
            .estimateReady = pending_.estimateReady,
            .estimateFailed = pending_.estimateFailed};
}

void Exploration::follow()
{
    if (!latest_) return;
    const FollowInput in = followed();
    pending_ = AtemInput{};
    if (in.aborted) track_.reset();
    if (in.linkLost) {  // who knows what the robot did meanwhile
        capturedPress_ = 0;
        commandedAt_ = latest_->count;
    }
    const AtemState before = state_;
    state_ = nextFollowed(state_, in, options_.limits);
    if (state_ != before) enterFollowed();
    if (moved_ && estimate_) forget(whyMoved());
}

void Exploration::enterFollowed()
{
    switch (state_.phase) {
    case AtemPhase::Pressing: forget(tr("Following: the front flippers press down")); break;
    case AtemPhase::Estimating:
        forget(tr("Estimating …"));
        emit happened(tr("following: the robot has pressed its flippers down"), Weight::Note);
        capturedPress_ = latest_->press->count;
        capture();
        startEstimate();
        break;
    case AtemPhase::Probing:
        emit happened(tr("following: the arm is probing"), Weight::Note);
        break;
    case AtemPhase::EstimatingAgain: finishProbe(*latest_->sample.measurement.arm); break;
    case AtemPhase::Stopped:
        emit happened(tr("following: the robot is stopped"), Weight::Bad);
        cancelEstimate();
        if (!estimate_) forget(tr("No estimate: the robot is stopped"));
        break;
    case AtemPhase::Failed: {
        const QString why = words::sentence(describe(state_.failure));
        emit happened(tr("following: no estimate: %1").arg(why), Weight::Bad);
        cancelEstimate();
        forget(tr("No estimate: %1").arg(why));
        break;
    }
    case AtemPhase::Idle:
        cancelEstimate();
        forget(moved_ ? whyMoved() : QString());
        break;
    case AtemPhase::Presenting:
    case AtemPhase::Halting:
    case AtemPhase::ProposingProbe: break;
    }
}

void Exploration::keepLive()
{
    if (state_.phase == AtemPhase::Estimating) return;  // the preview stays until there is better
    if (state_.phase != AtemPhase::Pressing) {
        live_.reset();
        return;
    }
    if (liveJob_ != 0 || modelName_.isEmpty() || latest_->count == liveCount_) return;
    liveCount_ = latest_->count;
    Settings settings = options_.settings;
    settings.method = Method::Local;
    settings.draws = kLiveDraws;
    liveJob_ = worker_.request(
        {.measurement = latest_->sample.measurement, .arm = {}, .settings = settings});
}

void Exploration::takeLive(const TerrainEstimate& estimate)
{
    liveJob_ = 0;
    live_ = estimate;
}

void Exploration::enter(const AtemState& before)
{
    const auto note = [this](const QString& text, Weight weight = Weight::Note) {
        emit happened(text, weight);
    };
    if (before.phase == AtemPhase::ProposingProbe && state_.phase != AtemPhase::Probing)
        proposal_.reset();
    switch (state_.phase) {
    case AtemPhase::Halting:
        forget(tr("Exploring: the robot halts"));
        note(tr("exploration requested"));
        command(BeginAtemCommand{});
        break;
    case AtemPhase::Pressing:
        whyNoEstimate_ = tr("Exploring: the front flippers press down");
        command(PressCommand{.torque = options_.pressTorque});
        break;
    case AtemPhase::Estimating:
        whyNoEstimate_ = tr("Estimating …");
        capture();
        startEstimate();
        break;
    case AtemPhase::ProposingProbe:
        emit proposed();
        note(tr("probe proposed at %1").arg(words::binName(proposal_->bin)));
        break;
    case AtemPhase::Probing:
        approved_ = std::exchange(proposal_, std::nullopt);
        note(tr("probe at %1 approved").arg(words::binName(approved_->bin)));
        sawProbing_ = false;
        armBefore_ = latest_->sample.measurement.arm;
        if (link_) link_->approve(approved_->bin);
        command(ProbeCommand{.bin = approved_->bin});
        break;
    case AtemPhase::EstimatingAgain: finishProbe(*latest_->sample.measurement.arm); break;
    case AtemPhase::Presenting:
        if (before.phase == AtemPhase::ProposingProbe) {
            if (state_.approvalExpired)
                note(tr("no answer in time: no probe"), Weight::Doubt);
            else
                note(tr("probe refused"));
        }
        proposal_.reset();
        command(AbortAtemCommand{});
        break;
    case AtemPhase::Idle:
        if (exploring(before.phase)) {
            cancelEstimate();
            command(AbortAtemCommand{});
            note(tr("exploration ended by the operator"), Weight::Doubt);
            if (!estimate_) forget(tr("No estimate: explore the terrain (A)"));
        }
        releasing_ = false;
        break;
    case AtemPhase::Stopped:
        cancelEstimate();
        note(tr("STOP"), Weight::Bad);
        if (!estimate_) forget(tr("No estimate: STOP was pressed"));
        break;
    case AtemPhase::Failed:
        cancelEstimate();
        if (linkAlive_) command(AbortAtemCommand{});
        note(tr("exploration failed: %1").arg(words::sentence(describe(state_.failure))),
             Weight::Bad);
        if (!estimate_)
            forget(tr("No estimate: %1").arg(words::sentence(describe(state_.failure))));
        break;
    }
}

// With the first line of the press, so that everybody who sees it captures the same.
void Exploration::capture()
{
    const bool isNew = latest_->press && latest_->press->count > commandedAt_;
    const Sample& sample = isNew ? latest_->press->sample : latest_->sample;
    scene_ = CapturedScene{.measurement = sample.measurement, .truth = sample.truth};
    readings_.clear();
    moved_ = false;
    movedAt_ = 0;
    emit captured(*scene_);
}

EstimateRequest Exploration::requestFor(Method method) const
{
    Settings settings = options_.settings;
    settings.method = !readings_.empty() && method == Method::Pafc ? Method::Pafac : method;
    return {.measurement = scene_->measurement,
            .arm = readings_,
            .settings = settings,
            .prober = {},
            .stepLimit = options_.stepLimit};
}

void Exploration::startEstimate()
{
    liveJob_ = secondJob_ = 0;  // this request overtakes them
    second_.reset();
    EstimateRequest request = requestFor(options_.settings.method);
    request.prober = robot_;
    job_ = worker_.request(request);
}

void Exploration::startSecond()
{
    if (secondMethod_ && estimate_ && scene_)
        secondJob_ = worker_.request(requestFor(*secondMethod_));
}

void Exploration::finishProbe(const ArmReading& reading)
{
    const auto i = static_cast<std::size_t>(reading.bin);
    const bool inside = estimate_->q10[i] <= reading.height && reading.height <= estimate_->q90[i];
    emit happened(tr("arm at %1: %2 m, %3 the band shown before")
                      .arg(words::binName(reading.bin), words::signedNumber(reading.height, 2),
                           inside ? tr("inside") : tr("outside")),
                  inside ? Weight::Note : Weight::Doubt);
    ledger_.record(*estimate_, reading.bin, reading.height, reading.sd, Origin::Arm);
    std::erase_if(readings_, [&](const ArmReading& r) { return r.bin == reading.bin; });
    readings_.push_back(reading);
    startEstimate();
}

void Exploration::cancelEstimate()
{
    worker_.cancel();
    job_ = liveJob_ = secondJob_ = 0;  // a result already on its way is not ours any more
}

void Exploration::forget(const QString& why)
{
    if (estimate_) emit forgotten(why);
    estimate_.reset();
    second_.reset();
    secondJob_ = 0;
    scene_.reset();
    proposal_.reset();
    moved_ = false;
    movedAt_ = 0;
    whyNoEstimate_ = why;
}

void Exploration::trackGhost(const std::optional<Received>& latest)
{
    if (track_ && latest && (!latest_ || latest->count != latest_->count))
        track_->take(latest->sample.measurement);
}

std::optional<NoGhost> Exploration::noGhost() const
{
    return linkAlive_ ? track_->why() : NoGhost::Unheard;
}

std::optional<Ghost> Exploration::ghost() const
{
    if (!track_ || estimate_ || live_ || noGhost()) return std::nullopt;
    return track_->ghost();
}

QString Exploration::whyNoGhost() const
{
    if (!track_ || estimate_ || live_) return {};
    const auto why = noGhost();
    return why ? tr("No ghost: %1").arg(words::sentence(describe(*why))) : QString();
}

std::optional<double> Exploration::timeLeft() const
{
    const auto end = deadline(state_, options_.limits);
    return end ? std::optional(std::max(0.0, *end - now_)) : std::nullopt;
}

std::optional<int> Exploration::probingBin() const
{
    return state_.phase == AtemPhase::Probing && approved_ ? std::optional(approved_->bin)
                                                           : std::nullopt;
}

QString Exploration::whyNotDriving() const
{
    if (following()) return whyFollowing_;
    if (state_.phase == AtemPhase::Stopped) return tr("STOP is latched: release it first");
    if (exploring(state_.phase)) return tr("An exploration is running: end it with Esc first");
    if (!linkAlive_) return tr("No telemetry from the robot");
    if (!armed()) return arming().text;
    return {};
}

Precondition Exploration::arming() const
{
    if (armed()) return {Precondition::Level::Met, tr("the robot is armed")};
    return {Precondition::Level::Missing,
            following() ? whyFollowing_ : tr("not armed: press M, then hold M")};
}

Precondition Exploration::planarity() const
{
    using Level = Precondition::Level;
    const Measurement& m = latest_->sample.measurement;
    const Settings& settings = options_.settings;
    const double asymmetry = flipperAsymmetry(m);
    const Level doubtful = planarOverridden_ ? Level::Overridden : Level::Doubtful;
    if (std::abs(m.roll) > settings.rollLimit)
        return {doubtful, tr("roll %1: left and right ground differ").arg(words::degrees(m.roll))};
    if (asymmetry > settings.asymmetryLimit)
        return {doubtful,
                tr("left and right flippers differ by %1").arg(words::degrees(asymmetry))};
    return {Level::Met, tr("left and right agree, roll is small")};
}

void Exploration::overrideDoubts()
{
    if (following() || !latest_) return;
    const Precondition doubt = planarity();
    if (doubt.level != Precondition::Level::Doubtful) return;
    planarOverridden_ = true;
    emit decided("override", doubt.text);
    emit happened(tr("overridden by the operator: %1").arg(doubt.text), Weight::Doubt);
}

QString Exploration::overridden() const
{
    return planarOverridden_ && latest_ ? planarity().text : QString();
}

QList<Precondition> Exploration::preconditions() const
{
    using Level = Precondition::Level;
    QList<Precondition> list;
    if (linkAlive_)
        list << Precondition{Level::Met, tr("telemetry is live")};
    else
        list << Precondition{Level::Missing,
                             ended_ ? tr("the log has ended") : tr("no telemetry from the robot")};
    if (state_.phase == AtemPhase::Stopped)
        list << Precondition{Level::Missing,
                             releasing_ ? tr("STOP: release sent, not yet confirmed by the robot")
                                        : tr("STOP is latched")};
    else
        list << Precondition{Level::Met, tr("STOP is not latched")};
    if (link_) list << arming();
    if (!modelTrouble_.isEmpty())
        list << Precondition{Level::Missing, tr("no model: %1").arg(modelTrouble_)};
    else if (modelName_.isEmpty())
        list << Precondition{Level::Missing, tr("the model is being loaded")};
    else
        list << Precondition{Level::Met, tr("model %1 is ready").arg(modelName_)};
    if (latest_) list << planarity();
    return list;
}

}  // namespace terratact
