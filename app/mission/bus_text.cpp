#include "app/mission/bus_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <optional>

#include "app/display/format.h"
#include "core/limits.h"
#include "core/wire/frame_layout.h"

namespace terratact {
namespace {

struct BusWords {
    Q_DECLARE_TR_FUNCTIONS(BusWords)
};

QString matter(BusState state)
{
    switch (state) {
    case BusState::Up: return BusWords::tr("%1 works");
    case BusState::Stalled:
        return BusWords::tr("%1 does not take frames: no node acknowledges them, or the bus is "
                            "full. Check the robot's power, the wires and the bit rate");
    case BusState::ErrorWarning:
        return BusWords::tr("%1 has errors: check wires, terminators and bit rate");
    case BusState::ErrorPassive:
        return BusWords::tr("%1 has many errors: check wires, terminators and bit rate");
    case BusState::BusOff:
        return BusWords::tr(
            "%1 is bus-off after too many errors: check the wires, then restart it");
    case BusState::Down: return BusWords::tr("%1 is down: bring it up");
    case BusState::Absent:
        return BusWords::tr("%1 does not exist: plug the adapter in, or make the interface");
    case BusState::Ended: return BusWords::tr("%1 has ended");
    }
    return QStringLiteral("%1");
}

QString troubleOf(BusState state, const std::string& bus, const std::string& said)
{
    const bool works = state == BusState::Up || state == BusState::ErrorWarning;
    return said.empty() || works ? format::sentence(said) : busWords(state, bus);
}

}  // namespace

QString busWords(BusState state, const std::string& bus)
{
    const QString sentence = matter(state).arg(format::shownName(bus));
    const std::string command = cureOf(state, bus);
    return command.empty() ? sentence
                           : sentence + QStringLiteral(" (%1)").arg(format::text(command));
}

QString glance(BusState state)
{
    switch (state) {
    case BusState::Up: return BusWords::tr("ACTIVE");
    case BusState::Stalled: return BusWords::tr("STALLED");
    case BusState::ErrorWarning: return BusWords::tr("WARNING");
    case BusState::ErrorPassive: return BusWords::tr("PASSIVE");
    case BusState::BusOff: return BusWords::tr("BUS-OFF");
    case BusState::Down: return BusWords::tr("DOWN");
    case BusState::Absent: return BusWords::tr("ABSENT");
    case BusState::Ended: return BusWords::tr("ENDED");
    }
    return {};
}

Tone toneOf(BusState state)
{
    switch (state) {
    case BusState::Up:
    case BusState::Ended: return Tone::Plain;
    case BusState::ErrorWarning: return Tone::Doubt;
    case BusState::Stalled:
    case BusState::ErrorPassive:
    case BusState::BusOff:
    case BusState::Down:
    case BusState::Absent: return Tone::Bad;
    }
    return Tone::Bad;
}

QString loadGlance(const BusLoad& load, const BitRate& bitrate)
{
    const double rate = bitrate.bitsPerSecond.value_or(0.0);
    if (!(rate > 0.0)) return QStringLiteral("--- %");
    return QStringLiteral("≤ %1 %").arg(format::percent(load.mostBits / rate));
}

QString troubleWords(const CanSource* link, const std::string& said)
{
    return link ? troubleOf(link->busState(), link->busName(), said) : format::sentence(said);
}

QString troubleWords(const CanView* bus, const std::string& said)
{
    return bus ? troubleOf(bus->bus, bus->busName, said) : format::sentence(said);
}

QString stillComes(const std::vector<TappedFrame>& frames, double silence)
{
    std::optional<double> youngest, heartbeat, status;
    for (const TappedFrame& frame : frames) {
        if (!frame.kind || !frame.age || layoutOf(*frame.kind).fromConsole) continue;
        youngest = std::min(youngest.value_or(*frame.age), *frame.age);
        if (frame.kind == FrameKind::RobotHeartbeat) heartbeat = frame.age;
        if (frame.kind == FrameKind::RobotStatus) status = frame.age;
    }
    if (!youngest || *youngest > std::min(kLinkLostAfter, 0.5 * silence)) return {};
    if (heartbeat)
        return BusWords::tr("frames still come, heartbeat %1 old").arg(format::age(*heartbeat));
    // The robot sends heartbeats only to a commanding console; a receive-only console sees only the status.
    if (status) return BusWords::tr("frames still come, status %1 old").arg(format::age(*status));
    return BusWords::tr("frames still come");
}

QString whyFollowing(const CanSource* link)
{
    if (!link) return {};
    const QString name = format::text(link->name());
    switch (link->mode()) {
    case CanSource::Mode::Transmit: return {};
    case CanSource::Mode::Listen:
        return BusWords::tr("%1 is receive-only: start the console with --transmit").arg(name);
    case CanSource::Mode::Replay: return BusWords::tr("%1 takes no commands").arg(name);
    }
    return {};
}

}  // namespace terratact
