#include "app/mission/estimation.h"

#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/memory_text.h"
#include "app/mission/text/place_text.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/infer/two_track_estimator.h"
#include "core/infer/verdict/estimate_text.h"

namespace terratact {
namespace {

constexpr int kLiveDraws = 200;  // enough draws for a preview

}  // namespace

Estimation::Estimation(EstimatorWorker& worker, const RobotModel& robot, const Options& options)
    : worker_(worker), robot_(robot), options_(options), strip_(robot), memory_(robot)
{
    listenToModels();
    connect(&worker_, &EstimatorWorker::estimated, this, &Estimation::accept);
    connect(&worker_, &EstimatorWorker::failed, this, &Estimation::refuse);
    connect(&worker_, &EstimatorWorker::advised, this, &Estimation::addAdvice);
}

void Estimation::addAdvice(int job, const ProbeAdvice& advice)
{
    // Advice for an older estimate may arrive late, because it waited behind the new request in the worker.
    if (!estimate_ || job != estimateJob_ || advice.stepLimit != options_.stepLimit) return;
    if (!unadvised_ && advice == advice_)
        return;  // the limit was changed and restored, so the advice came twice
    advice_ = advice;
    if (unadvised_)
        offer();
    else
        emit advised();
}

void Estimation::offer()
{
    unadvised_ = false;
    emit offered();
    startSecond();
}

void Estimation::listenToModels()
{
    connect(&worker_, &EstimatorWorker::modelLoaded, this,
            [this](const QString& name, const QString& details, const QString& /*hash*/,
                   const QString& content, bool hasTwoTracks, const TrailInUse& trail) {
                if (!model_.name.isEmpty()) strip_.endSection();  // it was felt by another model
                model_ = {.name = name,
                          .details = details,
                          .content = content,
                          .trouble = {},
                          .hasTwoTracks = hasTwoTracks,
                          .trail = trail};
                aside_.reset();
                emit modelChanged();
                emit happened(
                    Message(TR_NOOP("terratact::Estimation", "model %1 loaded"), verbatim(name)),
                    EventSeverity::Note);
                resume();
            });
    connect(&worker_, &EstimatorWorker::modelFailed, this, [this](const Message& why) {
        model_.trouble = why;
        emit happened(why, EventSeverity::Bad);
        resume();
    });
    connect(&worker_, &EstimatorWorker::modelKept, this, [this](const Message& why) {
        emit happened(Message(TR_NOOP("terratact::Estimation", "model %1 stays in use: %2"),
                              verbatim(model_.name), why),
                      EventSeverity::Bad);
        resume();
    });
}

void Estimation::poll(const std::optional<Received>& latest, bool telemetryFresh)
{
    telemetryFresh_ = telemetryFresh;
    if (!latest) return;
    const Measurement& newest = latest->sample.measurement;
    if (pose_) pose_->poll(newest, latest->count);
    if (aside_) {
        aside_->pose.poll(newest, latest->count);
        aside_->hadTelemetryGap =
            aside_->hadTelemetryGap || latest->unbrokenFrom > aside_->capturedAt;
    }
    if (scene_ && latest->unbrokenFrom > capturedAt_ && !std::exchange(hadTelemetryGap_, true))
        emit telemetryGap();
    if (scene_ && !hasMoved() && latest->count >= capturedAt_) suspect(latest->suspicions);
    if (latest->count == tracked_) return;
    if (tracked_ > 0 && latest->unbrokenFrom > tracked_) {
        const bool wasSeen = !strip_.whyNothing();
        strip_.addSilence();
        memory_.addSilence();
        if (aside_) aside_->memory.addSilence();
        if (wasSeen && !scene_) emit telemetryGap();
    }
    tracked_ = latest->count;
    strip_.add(newest, latest->suspicions);
    memory_.add(newest, latest->suspicions);
    if (aside_) aside_->memory.add(newest, latest->suspicions);
}

Estimation::Processes Estimation::processesOf(Method method) const
{
    return {method, options_.settings.inducing, options_.settings.precision};
}

bool Estimation::warmUp(Method method)
{
    const Processes processes = processesOf(method);
    if (isClosedForm(method) || std::find(made_.begin(), made_.end(), processes) != made_.end())
        return false;
    made_.push_back(processes);
    EstimateRequest request;
    request.settings = options_.settings;
    request.settings.method = method;
    request.prepares = true;
    warmUpJob_ = worker_.request(request);
    return true;
}

void Estimation::endWarmUp()
{
    if (std::exchange(warmUpJob_, 0) != 0) made_.pop_back();
}

void Estimation::prepare()
{
    const bool isBusy = job_ != 0 || secondJob_ != 0 || liveJob_ != 0 || warmUpJob_ != 0;
    if (isBusy || unadvised_ || model_.name.isEmpty() || warmUp(options_.settings.method)) return;
    if (secondMethod_) warmUp(*secondMethod_);
}

void Estimation::preview(const Received& latest)
{
    if (warmUpJob_ != 0 && made_.back() != processesOf(options_.settings.method))
        endWarmUp();  // those of the second method can wait
    if (liveJob_ != 0 || warmUpJob_ != 0 || model_.name.isEmpty() || latest.count == previewed_)
        return;
    previewed_ = latest.count;
    if (warmUp(options_.settings.method)) return;
    const Measurement& line = latest.sample.measurement;
    const SceneMemory memory =
        options_.settings.method == Method::Trail ? memory_.before(line) : SceneMemory{};
    Settings settings = options_.settings;
    settings.method = methodWith(Method::Trail, memory, model_.trail);
    settings.draws = kLiveDraws;
    liveJob_ = worker_.request(
        {.measurement = line, .arm = {}, .settings = settings, .memory = memory.history});
}

void Estimation::suspect(const std::vector<SensorSuspicion>& suspicions)
{
    wasSuspected_ = wasSuspected_ || !suspicions.empty();
    if (!suspicions.empty()) memory_.forgetFelt();
    wasPitchSuspected_ = wasPitchSuspected_ || isSuspected(suspicions, Sensor::Pitch);
}

void Estimation::begin(const Received& latest, std::uint64_t since)
{
    const bool isNew = latest.press && latest.press->count > since;
    const Sample& sample = isNew ? latest.press->sample : latest.sample;
    aside_.reset();
    scene_ = CapturedScene{.measurement = sample.measurement,
                           .truth = sample.truth,
                           .sideTruth = sample.sideTruth,
                           .memory = memory_.before(sample.measurement)};
    memory_.addScene(sample.measurement);
    pose_.emplace(sample.measurement);
    capturedAt_ = isNew ? latest.press->count : latest.count;
    hadTelemetryGap_ = wasSuspected_ = wasPitchSuspected_ = false;
    suspect(latest.suspicions);
    readings_ = memory_.armHere();
    strip_.beginScene(scene_->measurement);
    emit captured(*scene_);
    start();
}

void Estimation::score(const ArmReading& reading)
{
    const ProbePlace place{reading.bin, reading.side};
    if (!estimate_->onePlane && reading.side == ProbeSide::Middle)
        return void(emit happened(
            Message(TR_NOOP("terratact::Estimation",
                            "arm %1: %2 m, between the sides that are estimated"),
                    placeMessage(place), verbatim(format::signedNumber(reading.height, 2))),
            EventSeverity::Warning));
    const TerrainEstimate& shown = sideOf(*estimate_, reading.side);
    const auto i = static_cast<std::size_t>(reading.bin);
    const bool inside = shown.q10[i] <= reading.height && reading.height <= shown.q90[i];
    emit happened(
        Message(TR_NOOP("terratact::Estimation", "arm %1: %2 m, %3 the band shown before"),
                placeMessage(place), verbatim(format::signedNumber(reading.height, 2)),
                inside ? TR_NOOP("terratact::Estimation", "inside")
                       : TR_NOOP("terratact::Estimation", "outside")),
        inside ? EventSeverity::Note : EventSeverity::Warning);
    ledger_.record(shown, reading.bin, reading.height, reading.sd, Origin::Arm);
}

void Estimation::addArmReading(const ArmReading& reading)
{
    score(reading);
    std::erase_if(readings_, [&](const ArmReading& r) {
        return r.bin == reading.bin && r.side == reading.side;
    });
    readings_.push_back(reading);
    memory_.addArm(scene_->measurement, reading);
    start();
}

void Estimation::setSecondMethod(std::optional<Method> method)
{
    secondMethod_ = method;
    second_.reset();
    secondJob_ = 0;
    startSecond();
}

void Estimation::cancel()
{
    worker_.cancel();
    endWarmUp();
    job_ = liveJob_ = secondJob_ = 0;  // results of these jobs are dropped when they arrive
    if (std::exchange(unadvised_, false))
        adviseAnew();  // repeats the cancelled advice for the existing estimate
}

void Estimation::adviseAnew()
{
    if (!estimate_) return;
    if (advice_.stepLimit != options_.stepLimit)
        worker_.advise(estimateJob_, *estimate_, robot_, options_.stepLimit);
}

void Estimation::forget(const Message& why)
{
    if (estimate_) emit forgotten(why);
    estimate_.reset();
    second_.reset();
    job_ = secondJob_ = 0;
    unadvised_ = false;
    scene_.reset();
    pose_.reset();
    hadTelemetryGap_ = wasSuspected_ = wasPitchSuspected_ = false;
    readings_.clear();
    whyNone_ = why;
}

void Estimation::setAside(const Message& why)
{
    if (estimate_ && scene_ && pose_)
        aside_ = Aside{*scene_,    *pose_,          capturedAt_, hadTelemetryGap_, readings_,
                       *estimate_, second_.value(), memoryText_, memory_};
    memory_.clear();
    takeBack();
    forget(why);
}

bool Estimation::restore()
{
    if (!isAside() || scene_) return false;
    Aside aside = *std::exchange(aside_, std::nullopt);
    scene_ = aside.scene;
    pose_ = aside.pose;
    capturedAt_ = aside.capturedAt;
    hadTelemetryGap_ = aside.hadTelemetryGap;
    readings_ = std::move(aside.readings);
    estimate_ = std::move(aside.estimate);
    second_ = std::move(aside.second);
    memoryText_ = std::move(aside.memoryText);
    memory_ = std::move(aside.memory);
    strip_.enter(*estimate_, estimateJob_, readings_);
    whyNone_ = {};
    emit estimateReady(false);
    adviseAnew();  // if the limit has changed meanwhile
    return true;
}

EstimateRequest Estimation::requestFor(Method method) const
{
    Settings settings = options_.settings;
    settings.method = methodWith(method, scene_->memory, model_.trail);
    if (!readings_.empty() && method == Method::Pafc) settings.method = Method::Pafac;
    return {.measurement = scene_->measurement,
            .arm = readings_,
            .settings = settings,
            .prober = {},
            .stepLimit = options_.stepLimit,
            .seconds = options_.seconds,
            .prepares = false,
            .memory = scene_->memory.history};
}

void Estimation::start()
{
    liveJob_ = secondJob_ = 0;  // this request replaces them
    endWarmUp();
    unadvised_ = false;
    second_.reset();
    EstimateRequest request = requestFor(options_.settings.method);
    request.prober = robot_;
    askedLimit_ = request.stepLimit;
    askedMemory_ = terratact::memoryText(options_.settings.method, scene_->memory, model_.trail);
    job_ = worker_.request(request);
}

void Estimation::startSecond()
{
    // A request would replace the running job, and the advice would wait behind it.
    if (!secondMethod_ || !estimate_ || !scene_ || job_ != 0 || unadvised_) return;
    endWarmUp();
    secondJob_ = worker_.request(requestFor(*secondMethod_));
}

void Estimation::resume()
{
    liveJob_ = warmUpJob_ = 0;
    made_.clear();  // they belong to the previous model
    const bool second = secondJob_ != 0;
    secondJob_ = 0;
    if (job_ != 0)
        start();
    else if (unadvised_)
        adviseAnew();
    else if (second)
        startSecond();
}

void Estimation::accept(int job, const TwoTrackEstimate& estimate, double seconds)
{
    if (job == warmUpJob_) warmUpJob_ = 0;
    if (job == liveJob_) {
        liveJob_ = 0;
        live_ = estimate;
    }
    if (job == secondJob_) {
        secondJob_ = 0;
        second_ = estimate;
        emit estimateReady(true);
    }
    if (job != job_) return;
    job_ = 0;
    live_.reset();
    estimate_ = estimate;
    seconds_ = seconds;
    memoryText_ = askedMemory_;
    ++counts_.estimates;
    const auto& [left, right] = estimate.side;
    counts_.contradicting += left.contradicts || right.contradicts ? 1 : 0;
    advice_ = {};
    estimateJob_ = job;
    strip_.enter(estimate, job, readings_);
    emit estimateReady(false);
    announce(estimate);
    unadvised_ = true;
    // Advice follows, unless the step limit has changed; then another probe may be the best one.
    if (askedLimit_ != options_.stepLimit) adviseAnew();
}

void Estimation::refuse(int job, const Message& why)
{
    if (job == warmUpJob_) warmUpJob_ = 0;
    if (job == liveJob_) {
        liveJob_ = 0;
        live_.reset();
        whyNone_ = Message(TR_NOOP("terratact::Estimation", "No live estimate: %1"), why);
    }
    if (job == secondJob_) {
        secondJob_ = 0;
        emit happened(Message(TR_NOOP("terratact::Estimation", "no second estimate: %1"), why),
                      EventSeverity::Warning);
    }
    if (job != job_) return;
    job_ = 0;
    emit failed();
    emit happened(Message(TR_NOOP("terratact::Estimation", "estimate failed: %1"), why),
                  EventSeverity::Bad);
}

void Estimation::announce(const TwoTrackEstimate& estimate)
{
    emit happened(Message(TR_NOOP("terratact::Estimation", "estimate in %1"),
                          verbatim(format::age(seconds_))),
                  EventSeverity::Note);
    announceMemory();
    const auto& [left, right] = estimate.side;
    for (const Message& warning : ofBothSides(left.warnings, right.warnings))
        emit happened(warning, EventSeverity::Warning);
    for (const Message& sentence : ofBothSides(hiddenByBands(left, options_.stepLimit),
                                               hiddenByBands(right, options_.stepLimit)))
        emit happened(sentence, EventSeverity::Note);
}

std::optional<TwoTrackVerdict> Estimation::verdict() const
{
    if (!estimate_ || !scene_) return std::nullopt;
    return verdictOf(*estimate_, robot_, scene_->measurement,
                     {.telemetryFresh = telemetryFresh_,
                      .unbroken = !hadTelemetryGap_,
                      .sensorsSound = !wasSuspected_},
                     options_.stepLimit);
}

bool Estimation::estimatesBothSides(const Measurement& line) const
{
    return model_.hasTwoTracks && allowsBothSides(line, options_.settings.method);
}

void Estimation::takeBack()
{
    if (estimate_)
        strip_.removeLast();
    else
        strip_.endSection();
}

}  // namespace terratact
