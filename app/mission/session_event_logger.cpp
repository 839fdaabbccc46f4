#include "app/mission/session_event_logger.h"

#include <utility>

#include "app/display/translated.h"
#include "app/mission/screen_text.h"
#include "core/log/event_text.h"

namespace terratact {
namespace {

std::string severityWord(EventSeverity severity)
{
    switch (severity) {
    case EventSeverity::Note: return "note";
    case EventSeverity::Warning: return "doubt";
    case EventSeverity::Bad: return "bad";
    }
    return {};
}

/// Returns EventRow::number of an alarm state; 0: ended.
double numberOf(AlarmState state)
{
    switch (state) {
    case AlarmState::Unacknowledged: return 3.0;
    case AlarmState::Acknowledged: return 2.0;
    case AlarmState::Returned: return 1.0;
    }
    return 0.0;
}

/// Returns the name of a failure or a cause, which a session holds as it is.
template <class Enum>
Message named(Enum value)
{
    return Message::verbatim(std::string(name(value)));
}

}  // namespace

SessionEventLogger::SessionEventLogger(std::shared_ptr<SessionRecorder> recorder,
                                       Exploration& exploration, EstimatorWorker& worker,
                                       QObject* parent)
    : QObject(parent), recorder_(std::move(recorder)), exploration_(exploration)
{
    connectTo(exploration);
    connect(&worker, &EstimatorWorker::modelLoaded, this, &SessionEventLogger::logModel);
}

void SessionEventLogger::connectTo(Exploration& exploration)
{
    const Estimation* estimation = &exploration.estimation();
    connect(estimation, &Estimation::captured, this, [this](const CapturedScene& scene) {
        scene_ = recorder_->record(SceneRow{.id = 0,
                                            .time = 0,
                                            .measurement = scene.measurement,
                                            .truth = scene.truth,
                                            .sideTruth = scene.sideTruth,
                                            .memory = scene.memory.history});
    });
    connect(estimation, &Estimation::estimateReady, this, &SessionEventLogger::logEstimate);
    connect(&exploration, &Exploration::proposed, this, &SessionEventLogger::logProposal);
    connect(&exploration, &Exploration::decided, this, &SessionEventLogger::decision);
    connect(estimation, &Estimation::telemetryGap, this,
            [this] { log(EventKind::TelemetryGap, {}, {}); });
    connect(estimation, &Estimation::forgotten, this, [this](const Message& why) {
        log(EventKind::Forgotten, {}, why);
        estimate_ = proposal_ = 0;
    });
}

void SessionEventLogger::logModel(const QString& name, const QString& details, const QString& hash,
                                  const QString& /*content*/, bool /*hasTwoTracks*/,
                                  const TrailInUse& trail)
{
    model_ = recorder_->record(ModelRow{.id = 0,
                                        .time = 0,
                                        .name = name.toStdString(),
                                        .hash = hash.toStdString(),
                                        .details = details.toStdString(),
                                        .trailName = trail.name.toStdString(),
                                        .trailHash = trail.hash.toStdString()});
}

void SessionEventLogger::logEstimate(bool second)
{
    if (scene_ == 0 || model_ == 0) return;
    const Estimation& estimation = exploration_.estimation();
    EstimateRow row;
    row.scene = scene_;
    row.model = model_;
    row.readings = estimation.readings();
    if (estimate_ == 0 && !second) earlierReadings_ = row.readings;
    row.role = second                           ? EstimateRole::Second
             : row.readings == earlierReadings_ ? EstimateRole::First
                                                : EstimateRole::Again;
    row.seconds = second ? 0.0 : estimation.seconds();
    row.stepLimit = exploration_.options().stepLimit;
    row.estimate = second ? *estimation.second() : *estimation.estimate();
    const std::int64_t id = recorder_->record(std::move(row));
    if (!second) estimate_ = id;
}

void SessionEventLogger::logProposal()
{
    const auto& p = exploration_.proposal();
    if (!p || estimate_ == 0) return;
    ProposalRow row{.id = 0,
                    .time = 0,
                    .estimate = estimate_,
                    .bin = p->bin,
                    .side = p->side,
                    .height = p->height,
                    .q10 = p->q10,
                    .q90 = p->q90,
                    .sd = p->sd,
                    .limit = p->limit,
                    .armSd = p->armSd,
                    .seconds = p->seconds,
                    .stepLimit = p->stepLimit,
                    .bitsBefore = p->bitsBefore,
                    .grounds = exploration_.proposedOn()};
    const auto add = [&row](const ProbeWorth& worth) {
        row.offers.push_back({worth.bin, worth.varianceShare, worth.bitsAfter, worth.side});
    };
    if (p->worth) add(*p->worth);
    for (const ProbeWorth& other : p->others) add(other);
    proposal_ = recorder_->record(std::move(row));
}

void SessionEventLogger::log(EventKind kind, const std::string& subject, const Message& text,
                             std::optional<double> number)
{
    const bool isDecision = kind == EventKind::Decision || kind == EventKind::Marker;
    EventRow row = withText({.id = 0,
                             .time = 0,
                             .kind = kind,
                             .subject = subject,
                             .number = number,
                             .estimate = estimate_,
                             .proposal = exploration_.proposal() ? proposal_ : 0},
                            text);
    recorder_->record(isDecision ? withScreen(std::move(row), screenText(exploration_, link_))
                                 : std::move(row));
}

void SessionEventLogger::decision(const char* what, const Message& text)
{
    log(EventKind::Decision, what, text);
}

void SessionEventLogger::word(const Message& text, EventSeverity severity)
{
    log(EventKind::Word, severityWord(severity), text);
}

void SessionEventLogger::mark(const QString& note)
{
    log(EventKind::Marker, "operator", verbatim(note));
}

void SessionEventLogger::snapshot(const QString& name)
{
    log(EventKind::Marker, "snapshot", verbatim(name));
}

void SessionEventLogger::noteSnapshot(const QString& name, const QString& note)
{
    log(EventKind::Marker, "snapshot note", verbatim(name + QStringLiteral(": ") + note));
}

void SessionEventLogger::poll(const LinkAccount& link, const std::optional<CanView>& bus,
                              const AlarmList& alarms, const std::optional<PanelState>& panel)
{
    logLink(link, bus);
    if (bus && std::exchange(arming_, bus->link.arming.phase) != bus->link.arming.phase)
        log(EventKind::Arming, std::string(name(*arming_)),
            *arming_ == ArmingPhase::Disarmed ? named(bus->link.arming.cause) : Message());
    const AtemState& state = exploration_.state();
    if (std::exchange(phase_, state.phase) != state.phase)
        log(EventKind::Phase, std::string(name(state.phase)),
            state.phase == AtemPhase::Failed ? named(state.failure) : Message());
    const Message overridden = Message::listed(exploration_.overridden(), "; ");
    if (std::exchange(overridden_, overridden) != overridden)
        log(EventKind::Override, {}, overridden);
    logAlarms(alarms);
    if (panel) logPanel(*panel);
}

void SessionEventLogger::logLink(const LinkAccount& link, const std::optional<CanView>& bus)
{
    link_ = link;
    if (link.standing == LinkStanding::Silent) return;
    const bool isUp = link.standing == LinkStanding::Up;
    const std::string subject{isUp ? kLinkUp : link.alone ? kTelemetryLost : kLinkLost};
    // A flapping link is recorded as one loss, unless it becomes worse.
    if (subject == loggedLink_ || (loggedLink_ == kLinkLost && !isUp)) return;
    loggedLink_ = subject;
    if (!isUp) return log(EventKind::Link, subject, bus ? describe(bus->bus, "bus") : Message());
    log(EventKind::Link, subject,
        link.gaps > 1 ? Message(TR_NOOP("core", "gaps before: %1, the longest %2 s"), link.gaps,
                                fixed(link.longest, 2))
                      : Message(),
        link.gaps > 0 ? std::optional(link.longest) : std::nullopt);
}

void SessionEventLogger::logAlarms(const AlarmList& alarms)
{
    std::map<std::string, AlarmState> now;
    for (const Alarm& alarm : alarms.alarms()) {
        now[alarm.id] = alarm.state;
        const auto before = alarms_.find(alarm.id);
        if (before == alarms_.end() || before->second != alarm.state)
            log(EventKind::Alarm, alarm.id, alarm.text, numberOf(alarm.state));
    }
    for (const auto& [id, state] : alarms_)
        if (!now.contains(id)) log(EventKind::Alarm, id, {}, 0.0);
    alarms_ = std::move(now);
}

void SessionEventLogger::logPanel(const PanelState& panel)
{
    PerContact<bool> closed;
    for (const PanelContact contact : kAllPanelContacts)
        closed[contact] = panel.contacts[contact].closed;
    for (const PanelContact contact : kAllPanelContacts)
        if (!contacts_ || (*contacts_)[contact] != closed[contact])
            log(EventKind::Panel, std::string(name(contact)), {}, closed[contact] ? 1.0 : 0.0);
    contacts_ = closed;
}

}  // namespace terratact
