#include "core/atem/loop_end.h"

#include <stdexcept>

#include "core/base/named.h"

namespace terratact {

SourceText describe(LoopEnd end)
{
    switch (end) {
    case LoopEnd::None: return TR_NOOP("core", "running");
    case LoopEnd::LetGo: return TR_NOOP("core", "the control was let go");
    case LoopEnd::Aborted: return TR_NOOP("core", "the operator ended it");
    case LoopEnd::Stop: return TR_NOOP("core", "STOP was pressed");
    case LoopEnd::Fault: return TR_NOOP("core", "a fault");
    case LoopEnd::ProbeProposed: return TR_NOOP("core", "a probe would decide");
    case LoopEnd::Stale: return TR_NOOP("core", "telemetry is stale or was interrupted");
    case LoopEnd::NoVerdict: return TR_NOOP("core", "there is no verdict");
    case LoopEnd::SensorFault: return TR_NOOP("core", "a sensor is suspected");
    case LoopEnd::Contradiction: return TR_NOOP("core", "the readings contradict the estimate");
    case LoopEnd::Withheld: return TR_NOOP("core", "the verdict is withheld");
    case LoopEnd::Blocked: return TR_NOOP("core", "BLOCKED: there is a step ahead");
    case LoopEnd::NotFelt: return TR_NOOP("core", "the ground ahead is not felt");
    case LoopEnd::ShortReach:
        return TR_NOOP("core", "the ground is felt less far than the flippers reach");
    case LoopEnd::Bounded: return TR_NOOP("core", "ground before the horizon is only bounded");
    case LoopEnd::Undecided: return TR_NOOP("core", "CANNOT TELL: what was felt does not decide");
    case LoopEnd::ShortHorizon:
        return TR_NOOP("core", "the ground is felt no further than the advance");
    case LoopEnd::Attitude: return TR_NOOP("core", "pitch or roll is near its limit");
    case LoopEnd::NoOdometry: return TR_NOOP("core", "the robot reports no odometry");
    }
    throw std::invalid_argument("describe: no such LoopEnd");
}

namespace {

constexpr auto kLoopEndNames = namesOf<LoopEnd>(
    "none", "let-go", "aborted", "stop", "fault", "probe-proposed", "stale", "no-verdict",
    "sensor-fault", "contradiction", "withheld", "blocked", "not-felt", "short-reach", "bounded",
    "undecided", "short-horizon", "attitude", "no-odometry");

}  // namespace

std::string_view name(LoopEnd end)
{
    return nameIn(kLoopEndNames, end);
}

}  // namespace terratact
