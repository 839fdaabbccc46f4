#include "core/strip/strip_section.h"

#include <stdexcept>

#include "core/base/named.h"

namespace terratact {
namespace {

constexpr auto kSectionStartNames = namesOf<SectionStart>(
    "first", "turned", "telemetry gap", "no odometry", "odometry jump", "suspected", "cleared");

}  // namespace

std::string_view name(SectionStart start)
{
    return nameIn(kSectionStartNames, start);
}

SourceText describe(SectionStart start)
{
    switch (start) {
    case SectionStart::First: return TR_NOOP("core", "the first felt ground");
    case SectionStart::Turned: return TR_NOOP("core", "the robot has turned");
    case SectionStart::TelemetryGap:
        return TR_NOOP("core",
                       "telemetry was missing for a while, in which the robot may have moved");
    case SectionStart::NoOdometry: return TR_NOOP("core", "the robot reports no odometry");
    case SectionStart::OdometryJump: return TR_NOOP("core", "the reported way has jumped");
    case SectionStart::Suspected: return TR_NOOP("core", "the odometry or the pitch is suspected");
    case SectionStart::Cleared: return TR_NOOP("core", "the remembered ground was cleared");
    }
    throw std::invalid_argument("describe: no such SectionStart");
}

}  // namespace terratact
