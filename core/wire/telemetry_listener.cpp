#include "core/wire/telemetry_listener.h"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

namespace terratact {
namespace {

constexpr auto kFirst = static_cast<std::size_t>(FrameKind::Odometry);

std::size_t indexOf(FrameKind kind)
{
    if (layoutOf(kind).fromConsole)
        throw std::invalid_argument("TelemetryListener: a console sends that frame");
    return static_cast<std::size_t>(kind) - kFirst;
}

}  // namespace

TelemetryListener::TelemetryListener(RobotModel robot) : robot_(std::move(robot))
{
    for (const FrameLayout& layout : frameLayouts().subspan(kFirst))
        receivers_.emplace_back(layout.dataId);
}

std::optional<Measurement> TelemetryListener::take(const CanFrame& frame, double now)
{
    if (!std::isfinite(now))
        throw std::invalid_argument("TelemetryListener: the time must be finite");
    const std::variant<Unpacked, FrameFault> got = unpack(frame);
    if (const auto* fault = std::get_if<FrameFault>(&got)) {
        refuse(frame, *fault, now);
        return std::nullopt;
    }
    const auto& content = std::get<Unpacked>(got);
    if (layoutOf(content.kind).fromConsole) {
        ++counters_.fromConsole;
        return std::nullopt;
    }
    const std::optional<RobotStatus> status = statusOf(content);
    if (content.kind == FrameKind::RobotStatus && !status) {
        refuse(frame, FrameFault::OutOfRange, now);
        return std::nullopt;
    }
    if (!isInOrder(frame, content.kind, now)) return std::nullopt;
    if (status) status_ = status;
    if (const auto token = tokenOf(content)) {
        token_ = token;
        challenge_ = challengeOf(content).value_or(0);
    }
    const std::optional<SensorLine> line = reader_.take(content);
    return line ? measured(*line, now) : std::nullopt;
}

// Counts a refused frame. Damaged bytes are an error of their link. A frame with wrong content and
// a right checksum counts as missing.
void TelemetryListener::refuse(const CanFrame& frame, FrameFault fault, double now)
{
    ++counters_.faults[static_cast<std::size_t>(fault)];
    if (fault != FrameFault::WrongCrc && fault != FrameFault::WrongLength) return;
    const std::optional<FrameKind> kind = kindOfId(frame.id);
    if (kind && !layoutOf(*kind).fromConsole)
        receivers_[indexOf(*kind)].receive({}, now);  // no bytes: never intact
}

bool TelemetryListener::isInOrder(const CanFrame& frame, FrameKind kind, double now)
{
    const FrameCheck check = receivers_[indexOf(kind)].receive(bytesOf(frame), now);
    switch (check) {
    case FrameCheck::SomeLost: ++counters_.gaps; [[fallthrough]];
    case FrameCheck::Ok: ++counters_.used; return true;
    case FrameCheck::Repeated: ++counters_.repeated; return false;
    case FrameCheck::WrongSequence: ++counters_.wrongSequence; return false;
    case FrameCheck::WrongCrc: break;  // unpack() has judged it before
    }
    return false;
}

std::optional<Measurement> TelemetryListener::measured(const SensorLine& line, double now)
{
    forces_ = elementForces(line, robot_);
    const LinkState link = this->link(FrameKind::RobotStatus, now);
    if (!status_ || link == LinkState::Lost) {
        ++counters_.orphans;
        return std::nullopt;
    }
    const std::optional<Measurement> measurement = measurementOf(line, forces_, *status_, now);
    ++(measurement ? counters_.lines : counters_.partial);
    return measurement;
}

LinkState TelemetryListener::link(FrameKind kind, double now) const
{
    return receivers_[indexOf(kind)].state(now);
}

std::optional<double> TelemetryListener::age(FrameKind kind, double now) const
{
    return receivers_[indexOf(kind)].age(now);
}

TelemetryCounters TelemetryListener::counters() const
{
    TelemetryCounters counters = counters_;
    counters.unfinished = reader_.unfinished();
    return counters;
}

}  // namespace terratact
