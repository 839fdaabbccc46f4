#include "app/mission/text/bus_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <optional>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "core/limits.h"
#include "core/wire/frame_layout.h"

namespace terratact {
namespace {

struct BusWords {
    Q_DECLARE_TR_FUNCTIONS(BusWords)
};

Message troubleOf(BusState state, const std::string& bus, const Message& said)
{
    const bool works = state == BusState::Up || state == BusState::ErrorWarning;
    return said.empty() || works ? said : describe(state, bus);
}

}  // namespace

QString busStateText(BusState state, const std::string& bus)
{
    return translated(describe(state, format::shownName(bus).toStdString()));
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
    case BusState::ErrorWarning: return Tone::Warning;
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

Message troubleOf(const CanSource* link, const Message& said)
{
    return link ? troubleOf(link->busState(), link->busName(), said) : said;
}

Message troubleOf(const CanView* bus, const Message& said)
{
    return bus ? troubleOf(bus->bus, bus->busName, said) : said;
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

std::optional<Message> whyFollowing(const CanSource* link)
{
    return link ? link->whyNotTransmitting() : std::nullopt;
}

}  // namespace terratact
