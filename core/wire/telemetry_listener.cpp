#include "core/wire/telemetry_listener.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace terratact {
namespace {

FrameKind ofRobot(FrameKind kind)
{
    if (layoutOf(kind).fromConsole)
        throw std::invalid_argument("TelemetryListener: a console sends that frame");
    return kind;
}

}  // namespace

TelemetryListener::TelemetryListener(RobotModel robot)
    : robot_(std::move(robot)), reader_(lineExtent(robot_))
{
}

const JudgedFrame& TelemetryListener::judge(const CanFrame& frame, double now)
{
    if (!std::isfinite(now))
        throw std::invalid_argument("TelemetryListener: the time must be finite");
    judged_ = validator_.judge(frame, now);
    return judged_;
}

std::optional<Measurement> TelemetryListener::receive(const CanFrame& frame, double now)
{
    judge(frame, now);
    if (judged_.fault) {
        ++counters_.faults[static_cast<std::size_t>(*judged_.fault)];
        return std::nullopt;
    }
    const Unpacked& content = judged_.content;
    if (layoutOf(content.kind).fromConsole) {
        ++counters_.fromConsole;
        return std::nullopt;
    }
    if (!isInOrder(judged_.check)) return std::nullopt;
    if (const auto status = statusOf(content)) status_ = status;
    if (const auto token = tokenOf(content)) {
        token_ = token;
        challenge_ = challengeOf(content).value_or(0);
    }
    const std::optional<SensorLine> line = reader_.add(content);
    return line ? measured(*line, now) : std::nullopt;
}

bool TelemetryListener::isInOrder(FrameCheck check)
{
    switch (check) {
    case FrameCheck::SomeLost: ++counters_.gaps; [[fallthrough]];
    case FrameCheck::Ok: ++counters_.used; return true;
    case FrameCheck::Repeated: ++counters_.repeated; return false;
    case FrameCheck::WrongSequence: ++counters_.wrongSequence; return false;
    case FrameCheck::WrongCrc: break;  // such a frame has a fault
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
    return validator_.link(ofRobot(kind), now);
}

std::optional<double> TelemetryListener::age(FrameKind kind, double now) const
{
    return validator_.age(ofRobot(kind), now);
}

TelemetryCounters TelemetryListener::counters() const
{
    TelemetryCounters counters = counters_;
    counters.unfinished = reader_.unfinished();
    return counters;
}

}  // namespace terratact
