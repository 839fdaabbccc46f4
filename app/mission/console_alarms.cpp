#include "app/mission/console_alarms.h"

#include <map>
#include <set>
#include <string>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/text/bus_text.h"

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

/// Returns "left 3 open, right 1 short"; nothing if all are usable. Saturated elements are pressed hard and are shown
/// by the bars.
std::optional<Message> unsoundElements(const ElementForces& forces)
{
    std::vector<Message> unsound;
    const auto poll = [&](const auto& side, SourceText element) {
        for (std::size_t i = 0; i < side.size(); ++i)
            if (side[i]
                && (side[i]->state == ElementState::Open || side[i]->state == ElementState::Short))
                unsound.emplace_back(element, i + 1, describe(side[i]->state));
    };
    poll(forces.left, TR_NOOP("terratact::ConsoleAlarms", "left %1 %2"));
    poll(forces.right, TR_NOOP("terratact::ConsoleAlarms", "right %1 %2"));
    if (unsound.empty()) return std::nullopt;
    return Message::listed(std::move(unsound), ", ");
}

/// Returns "Danger of tipping over: pitch +48°, tips over at +51°".
Message tiltMessage(const Measurement& m, const Attitude& attitude)
{
    std::vector<Message> angles;
    if (attitude.pitch != AttitudeLevel::Level)
        angles.emplace_back(TR_NOOP("terratact::ConsoleAlarms", "pitch %1, tips over at %2"),
                            verbatim(format::degrees(m.pitch)),
                            verbatim(format::degrees(attitude.pitchTips)));
    if (attitude.roll != AttitudeLevel::Level)
        angles.emplace_back(TR_NOOP("terratact::ConsoleAlarms", "roll %1, tips over at %2"),
                            verbatim(format::degrees(m.roll)),
                            verbatim(format::degrees(attitude.rollTips)));
    return {attitude.worst() == AttitudeLevel::Red
                ? TR_NOOP("terratact::ConsoleAlarms", "Danger of tipping over: %1")
                : TR_NOOP("terratact::ConsoleAlarms", "Steep: %1"),
            Message::listed(std::move(angles), "; ")};
}

/// Returns what the alarm of a link that is not good begins with.
SourceText linkFault(const LinkAccount& link)
{
    if (link.standing == LinkStanding::Unsteady)
        return link.alone ? TR_NOOP("terratact::ConsoleAlarms", "Telemetry unsteady")
                          : TR_NOOP("terratact::ConsoleAlarms", "Link unsteady");
    return link.alone ? TR_NOOP("terratact::ConsoleAlarms", "Telemetry lost")
                      : TR_NOOP("terratact::ConsoleAlarms", "Link lost");
}

/// Returns "fault: cause", or the fault alone.
Message withCause(const Message& fault, const Message& cause)
{
    return cause.empty() ? fault : Message::joined(fault, cause);
}

}  // namespace

Message suspicionMessage(const std::vector<SensorSuspicion>& suspicions)
{
    std::map<SensorTrouble, std::vector<Message>> sensors;
    std::map<SensorTrouble, Message> troubles;
    for (const SensorSuspicion& suspicion : suspicions) {
        sensors[suspicion.trouble].emplace_back(describe(suspicion.sensor));
        troubles[suspicion.trouble] = describeTrouble(suspicion);
    }
    std::vector<Message> sentences;
    sentences.reserve(sensors.size());
    for (auto& [trouble, names] : sensors)
        sentences.push_back(
            Message::joined(Message::listed(std::move(names), ", "), troubles[trouble]));
    return Message::listed(std::move(sentences), "; ");
}

ConsoleAlarms::ConsoleAlarms(std::unique_ptr<AlarmSound> alarmSound, QObject* parent)
    : QObject(parent), alarmSound_(std::move(alarmSound))
{
}

void ConsoleAlarms::poll(double now, const AlarmViewState& viewState)
{
    now_ = now;
    if (!began_) began_ = now;
    checkLink(viewState);
    if (viewState.bus) checkBus(*viewState.bus, viewState);
    judge("model", !viewState.noModel.empty(),
          Message(TR_NOOP("terratact::ConsoleAlarms", "No model, so nothing can be estimated: %1"),
                  viewState.noModel),
          Severity::Critical);
    judge("panel", !viewState.panelTrouble.empty(), viewState.panelTrouble, Severity::Critical);
    judge("exploration", !viewState.failedExploration.empty(),
          Message(TR_NOOP("terratact::ConsoleAlarms", "Exploration failed: %1"),
                  viewState.failedExploration),
          Severity::Caution);
    judge("recording", !viewState.notRecorded.empty(),
          Message(TR_NOOP("terratact::ConsoleAlarms", "Not recorded: %1"), viewState.notRecorded),
          Severity::Caution);
    checkSuspicions(viewState);
    checkAttitude(viewState);
    checkHalt(viewState);
    judge(
        "stop", viewState.isStopped,
        TR_NOOP("terratact::ConsoleAlarms", "The robot is stopped and moves only after a release"),
        Severity::Caution);
    if (list_.consumeSound(now) && soundOn_) trySound();
}

void ConsoleAlarms::trySound()
{
    alarmSound_->sound();
    emit sounded();
}

void ConsoleAlarms::checkLink(const AlarmViewState& viewState)
{
    const LinkAccount& link = viewState.link;
    const bool came = link.standing != LinkStanding::Silent;
    const bool waits = viewState.bus && viewState.bus->waits;
    const bool ended = viewState.bus && viewState.bus->ended;
    if (waits) began_ = now_;  // no alarm is due yet
    judge("silence", !came && !ended && now_ - *began_ >= kFirstTelemetry,
          withCause(TR_NOOP("terratact::ConsoleAlarms", "No telemetry since the start"),
                    viewState.sourceTrouble),
          Severity::Critical);
    judge("link", came && !link.alive && !ended,
          link.standing == LinkStanding::Unsteady
              ? Message(TR_NOOP("terratact::ConsoleAlarms", "%1; gaps: %2, the longest %3"),
                        linkFault(link), link.gaps, verbatim(format::age(link.longest)))
              : withCause(linkFault(link), viewState.sourceTrouble),
          Severity::Critical);
}

void ConsoleAlarms::checkBus(const CanView& bus, const AlarmViewState& viewState)
{
    judge("bus", toneOf(bus.bus) != Tone::Plain, describe(bus.bus, bus.busName),
          comesAndGoes(bus.bus) ? Severity::Caution : Severity::Critical,
          comesAndGoes(bus.bus) ? kFlutter : 0.0);
    judge("foreign", bus.link.foreignSender && bus.transmits,
          TR_NOOP("terratact::ConsoleAlarms",
                  "Another console sends commands on this bus: find it and turn it off"),
          Severity::Critical);
    judge("dropped", counted_["dropped"].grewLately(bus.frames.dropped, now_),
          Message(TR_NOOP("terratact::ConsoleAlarms",
                          "This computer was too slow for the bus: %1 frames lost since the start"),
                  bus.frames.dropped),
          Severity::Caution);
    judge("checksum", counted_["checksum"].grewLately(viewState.wrongChecksums, now_),
          Message(TR_NOOP("terratact::ConsoleAlarms",
                          "Damaged frames: %1 with a wrong checksum since the start"),
                  viewState.wrongChecksums),
          Severity::Caution);
    checkSensors(bus.forces);
    checkArming(bus.link.arming);
}

/// An unwanted disarming stays an alarm until the operator arms again. Otherwise the stop would pass for one that the
/// operator requested.
void ConsoleAlarms::checkArming(const ArmingState& arming)
{
    const bool isArmed = arming.phase == ArmingPhase::Armed;
    const bool hasEnded = std::exchange(wasArmed_, isArmed) && !isArmed;
    if (hasEnded && arming.cause != DisarmCause::Operator && arming.cause != DisarmCause::Stop)
        disarmedBy_ = arming.cause;
    else if (arming.phase != ArmingPhase::Disarmed)
        disarmedBy_.reset();
    const DisarmCause cause = disarmedBy_.value_or(DisarmCause::None);
    judge("disarmed", disarmedBy_.has_value(),
          Message(TR_NOOP("terratact::ConsoleAlarms", "Disarmed: %1"), describe(cause)),
          Severity::Critical);
}

void ConsoleAlarms::checkSensors(const ElementForces& forces)
{
    const auto unsound = unsoundElements(forces);
    judge("sensors", unsound.has_value(),
          Message(TR_NOOP("terratact::ConsoleAlarms", "Force sensors not usable: %1"),
                  unsound.value_or(Message())),
          Severity::Caution, kFlutter);
}

/// A suspicion stays an alarm while it withholds a verdict, and then names what was suspected.
void ConsoleAlarms::checkSuspicions(const AlarmViewState& viewState)
{
    if (!viewState.suspicions.empty()) suspected_ = suspicionMessage(viewState.suspicions);
    const bool stands = !viewState.suspicions.empty() || viewState.isSceneSuspected;
    judge(std::string(kSensorAlarm), stands,
          Message(TR_NOOP("terratact::ConsoleAlarms", "Do not trust this sensor: %1"), suspected_),
          Severity::Critical);
}

void ConsoleAlarms::checkAttitude(const AlarmViewState& viewState)
{
    const Attitude& attitude = viewState.attitude;
    const bool stands = viewState.measurement && attitude.worst() != AttitudeLevel::Level;
    judge("attitude", stands, stands ? tiltMessage(*viewState.measurement, attitude) : Message(),
          attitude.worst() == AttitudeLevel::Red ? Severity::Critical : Severity::Caution,
          kTiltFlutter);
}

/// A robot that halts with a refusal halted itself; the alarm gives its reason until the next drive or press.
void ConsoleAlarms::checkHalt(const AlarmViewState& viewState)
{
    if (viewState.measurement) {
        const Measurement& m = *viewState.measurement;
        const bool hasHalted = m.activity == RobotActivity::Halted && m.refusal != Refusal::None;
        const bool moved =
            activity_ != RobotActivity::Halted && activity_ != RobotActivity::Stopped;
        if (hasHalted && moved) {
            halted_ = describe(m.refusal);
            if (viewState.attitude.worst() != AttitudeLevel::Level)
                halted_ = Message::listed({halted_, tiltMessage(m, viewState.attitude)}, ". ");
        } else if (m.activity != RobotActivity::Halted) {
            halted_ = {};
        }
        activity_ = m.activity;
    }
    judge(
        "halted", !halted_.empty(),
        Message(TR_NOOP("terratact::ConsoleAlarms", "The robot has halted by itself: %1"), halted_),
        Severity::Caution);
}

void ConsoleAlarms::judge(const std::string& id, bool stands, const Message& text,
                          Severity severity, double after)
{
    Cause& cause = causes_[id];
    if (stands) {
        cause.gone.reset();
        if (!cause.stands) cause.stands = now_;
        if (now_ - *cause.stands < after) return;
        list_.raise(id, text, severity, now_);
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
