#include "app/mission/way_memory.h"

#include "app/mission/memory_text.h"

namespace terratact {

void WayMemory::add(const Measurement& line, const std::vector<SensorSuspicion>& suspicions)
{
    if (isWaySuspected(suspicions)) return record_.end(SectionStart::Suspected);
    if (!suspicions.empty()) record_.forgetFelt();
    record_.add(line);
}

SceneMemory WayMemory::before(const Measurement& scene) const
{
    const TrailHistory history = record_.before(scene);
    if (isUsable(history)) return {.history = history};
    return {.why = why()};
}

Message WayMemory::why() const
{
    const Message why = describe(record_.why());
    switch (record_.why()) {
    case SectionStart::First:
        return noMemory(TR_NOOP("terratact::Estimation", "the way begins here"));
    case SectionStart::NoOdometry:
    case SectionStart::Suspected: return noMemory(why);
    case SectionStart::Turned:
    case SectionStart::TelemetryGap:
    case SectionStart::OdometryJump:
    case SectionStart::Cleared: break;
    }
    return {TR_NOOP("terratact::Estimation", "memory cleared: %1"), why};
}

Method methodWith(Method wanted, const SceneMemory& memory, const TrailInUse& networks)
{
    const bool isRemembered = memory.history && !networks.name.isEmpty();
    return wanted == Method::Trail && !isRemembered ? Method::Local : wanted;
}

}  // namespace terratact
