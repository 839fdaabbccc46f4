#include "app/mission/console_alarms.h"

#include <QStringList>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "app/display/format.h"
#include "app/mission/bus_text.h"

namespace terratact {
namespace {

constexpr double kTiltFlutter = 0.15;  // [s] longer than noise in one sample
constexpr double kFlutter = 1.0;       // [s] such states occur this long on a working bus

/// Causes that no other text on the screen shows.
const std::set<std::string> kOnlyHere{"bus",      "foreign", "dropped",
                                      "checksum", "sensors", std::string(kSensorAlarm),
                                      "attitude", "halted"};

bool comesAndGoes(BusState state)
{
    return state == BusState::Stalled || state == BusState::ErrorWarning
        || state == BusState::ErrorPassive;
}

/// Returns "left 3 open, right 1 short". Saturated elements are pressed hard and are shown by the bars.
QString unsoundElements(const ElementForces& forces)
{
    QStringList unsound;
    const auto poll = [&](const auto& side, const QString& name) {
        for (std::size_t i = 0; i < side.size(); ++i)
            if (side[i]
                && (side[i]->state == ElementState::Open || side[i]->state == ElementState::Short))
                unsound << QStringLiteral("%1 %2 %3")
                               .arg(name)
                               .arg(i + 1)
                               .arg(format::sentence(describe(side[i]->state)));
    };
    poll(forces.left, ConsoleAlarms::tr("left"));
    poll(forces.right, ConsoleAlarms::tr("right"));
    return unsound.join(QStringLiteral(", "));
}

/// Returns "Danger of tipping over: pitch +48°, tips over at +51°".
QString tiltWords(const Measurement& m, const Attitude& attitude)
{
    QStringList angles;
    if (attitude.pitch != AttitudeLevel::Level)
        angles << ConsoleAlarms::tr("pitch %1, tips over at %2")
                      .arg(format::degrees(m.pitch), format::degrees(attitude.pitchTips));
    if (attitude.roll != AttitudeLevel::Level)
        angles << ConsoleAlarms::tr("roll %1, tips over at %2")
                      .arg(format::degrees(m.roll), format::degrees(attitude.rollTips));
    const QString all = angles.join(QStringLiteral("; "));
    return attitude.worst() == AttitudeLevel::Red
             ? ConsoleAlarms::tr("Danger of tipping over: %1").arg(all)
             : ConsoleAlarms::tr("Steep: %1").arg(all);
}

}  // namespace

QString suspicionWords(const std::vector<SensorSuspicion>& suspicions)
{
    QStringList sentences;
    std::map<SensorTrouble, QStringList> sensors;
    std::map<SensorTrouble, QString> troubles;
    for (const SensorSuspicion& suspicion : suspicions) {
        sensors[suspicion.trouble] << format::sentence(describe(suspicion.sensor));
        troubles[suspicion.trouble] = format::sentence(describeTrouble(suspicion));
    }
    for (const auto& [trouble, names] : sensors)
        sentences << QStringLiteral("%1: %2").arg(names.join(QStringLiteral(", ")),
                                                  troubles[trouble]);
    return sentences.join(QStringLiteral("; "));
}

ConsoleAlarms::ConsoleAlarms(std::unique_ptr<AlarmSound> alarmSound, QObject* parent)
    : QObject(parent), alarmSound_(std::move(alarmSound))
{
}

void ConsoleAlarms::poll(double now, const AlarmViewState& viewState)
{
    now_ = now;
    if (!began_) began_ = now;
    lookAtLink(viewState);
    if (viewState.bus) lookAtBus(*viewState.bus, viewState);
    judge("model", !viewState.noModel.isEmpty(),
          tr("No model, so nothing can be estimated: %1").arg(viewState.noModel),
          Severity::Critical);
    judge("panel", !viewState.panelTrouble.isEmpty(), viewState.panelTrouble, Severity::Critical);
    judge("exploration", !viewState.failedExploration.isEmpty(),
          tr("Exploration failed: %1").arg(viewState.failedExploration), Severity::Caution);
    judge("recording", !viewState.notRecorded.isEmpty(),
          tr("Not recorded: %1").arg(viewState.notRecorded), Severity::Caution);
    lookAtSuspicions(viewState);
    lookAtAttitude(viewState);
    lookAtHalt(viewState);
    judge("stop", viewState.isStopped, tr("The robot is stopped and moves only after a release"),
          Severity::Caution);
    if (list_.consumeSound(now) && soundOn_) trySound();
}

void ConsoleAlarms::trySound()
{
    alarmSound_->sound();
    emit sounded();
}

void ConsoleAlarms::lookAtLink(const AlarmViewState& viewState)
{
    const QString why = viewState.sourceTrouble.isEmpty()
                          ? QString()
                          : QStringLiteral(": ") + viewState.sourceTrouble;
    const LinkAccount& link = viewState.link;
    const bool came = link.standing != LinkStanding::Silent;
    const bool waits = viewState.bus && viewState.bus->waits;
    const bool ended = viewState.bus && viewState.bus->ended;
    if (waits) began_ = now_;  // no alarm is due yet
    judge("silence", !came && !ended && now_ - *began_ >= kFirstTelemetry,
          tr("No telemetry since the start%1").arg(why), Severity::Critical);
    QString what = format::sentence(describe(link));
    what.replace(0, 1, what.left(1).toUpper());
    judge("link", came && !link.alive && !ended,
          link.standing == LinkStanding::Unsteady
              ? tr("%1; gaps: %2, the longest %3")
                    .arg(what, QString::number(link.gaps), format::age(link.longest))
              : what + why,
          Severity::Critical);
}

void ConsoleAlarms::lookAtBus(const CanView& bus, const AlarmViewState& viewState)
{
    judge("bus", toneOf(bus.bus) != Tone::Plain, busWords(bus.bus, bus.busName),
          comesAndGoes(bus.bus) ? Severity::Caution : Severity::Critical,
          comesAndGoes(bus.bus) ? kFlutter : 0.0);
    judge("foreign", bus.link.foreignSender && bus.transmits,
          tr("Another console sends commands on this bus: find it and turn it off"),
          Severity::Critical);
    judge("dropped", counted_["dropped"].grewLately(bus.frames.dropped, now_),
          tr("This computer was too slow for the bus: %1 frames lost since the start")
              .arg(bus.frames.dropped),
          Severity::Caution);
    judge("checksum", counted_["checksum"].grewLately(viewState.wrongChecksums, now_),
          tr("Damaged frames: %1 with a wrong checksum since the start")
              .arg(viewState.wrongChecksums),
          Severity::Caution);
    lookAtSensors(bus.forces);
    lookAtArming(bus.link.arming);
}

/// An unwanted disarming stays an alarm until the operator arms again. Otherwise the stopped robot would look as if it
/// was told to stop.
void ConsoleAlarms::lookAtArming(const ArmingState& arming)
{
    const bool isArmed = arming.phase == ArmingPhase::Armed;
    const bool hasEnded = std::exchange(wasArmed_, isArmed) && !isArmed;
    if (hasEnded && arming.cause != DisarmCause::Operator && arming.cause != DisarmCause::Stop)
        disarmedBy_ = arming.cause;
    else if (arming.phase != ArmingPhase::Disarmed)
        disarmedBy_.reset();
    const DisarmCause cause = disarmedBy_.value_or(DisarmCause::None);
    judge("disarmed", disarmedBy_.has_value(),
          tr("Disarmed: %1").arg(format::sentence(describe(cause))), Severity::Critical);
}

void ConsoleAlarms::lookAtSensors(const ElementForces& forces)
{
    const QString unsound = unsoundElements(forces);
    judge("sensors", !unsound.isEmpty(), tr("Force sensors not usable: %1").arg(unsound),
          Severity::Caution, kFlutter);
}

/// A suspicion stays an alarm while a verdict is withheld because of it, and then names what was suspected.
void ConsoleAlarms::lookAtSuspicions(const AlarmViewState& viewState)
{
    if (!viewState.suspicions.empty()) suspected_ = suspicionWords(viewState.suspicions);
    const bool stands = !viewState.suspicions.empty() || viewState.isSceneSuspected;
    judge(std::string(kSensorAlarm), stands, tr("Do not trust this sensor: %1").arg(suspected_),
          Severity::Critical);
}

void ConsoleAlarms::lookAtAttitude(const AlarmViewState& viewState)
{
    const Attitude& attitude = viewState.attitude;
    const bool stands = viewState.measurement && attitude.worst() != AttitudeLevel::Level;
    judge("attitude", stands, stands ? tiltWords(*viewState.measurement, attitude) : QString(),
          attitude.worst() == AttitudeLevel::Red ? Severity::Critical : Severity::Caution,
          kTiltFlutter);
}

/// A robot that halts with a refusal halted itself; the alarm gives its reason until the next drive or press.
void ConsoleAlarms::lookAtHalt(const AlarmViewState& viewState)
{
    if (viewState.measurement) {
        const Measurement& m = *viewState.measurement;
        const bool hasHalted = m.activity == RobotActivity::Halted && m.refusal != Refusal::None;
        const bool moved =
            activity_ != RobotActivity::Halted && activity_ != RobotActivity::Stopped;
        if (hasHalted && moved) {
            halted_ = format::sentence(describe(m.refusal));
            if (viewState.attitude.worst() != AttitudeLevel::Level)
                halted_ += QStringLiteral(". ") + tiltWords(m, viewState.attitude);
        } else if (m.activity != RobotActivity::Halted) {
            halted_.clear();
        }
        activity_ = m.activity;
    }
    judge("halted", !halted_.isEmpty(), tr("The robot has halted by itself: %1").arg(halted_),
          Severity::Caution);
}

void ConsoleAlarms::judge(const std::string& id, bool stands, const QString& text,
                          Severity severity, double after)
{
    Cause& cause = causes_[id];
    if (stands) {
        cause.gone.reset();
        if (!cause.stands) cause.stands = now_;
        if (now_ - *cause.stands < after) return;
        list_.raise(id, text.toStdString(), severity, now_);
        if (cause.raised == severity || cause.raised == Severity::Critical) return;
        cause.raised = severity;
        if (kOnlyHere.contains(id)) emit raised(text, severity);
        return;
    }
    if (!cause.stands) return;
    if (!cause.gone) cause.gone = now_;
    if (now_ - *cause.gone < kGoneFor) return;
    list_.clear(id, now_);
    cause = {};
}

}  // namespace terratact
