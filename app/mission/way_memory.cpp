#include "app/mission/way_memory.h"

#include "app/mission/memory_text.h"

namespace terratact {

void WayMemory::add(const Measurement& line, const std::vector<SensorSuspicion>& suspicions)
{
    if (isSuspected(suspicions, Sensor::Travelled) || isSuspected(suspicions, Sensor::Pitch)) {
        record_.end(SectionStart::OdometryJump);
        isSuspected_ = true;
        return;
    }
    if (!suspicions.empty()) record_.forgetFelt();
    const SectionStart before = record_.why();
    record_.add(line);
    if (record_.why() != before) isSuspected_ = false;
}

void WayMemory::addSilence()
{
    record_.addSilence();
    isSuspected_ = false;
}

void WayMemory::clear()
{
    record_.end(SectionStart::Cleared);
    isSuspected_ = false;
}

SceneMemory WayMemory::before(const Measurement& scene) const
{
    const TrailHistory history = record_.before(scene);
    if (isUsable(history)) return {.history = history};
    return {.why = why()};
}

Message WayMemory::why() const
{
    if (isSuspected_)
        return noMemory(TR_NOOP("terratact::Estimation", "the odometry or the pitch is suspected"));
    switch (record_.why()) {
    case SectionStart::First:
        return noMemory(TR_NOOP("terratact::Estimation", "the way begins here"));
    case SectionStart::NoOdometry: return noMemory(describe(SectionStart::NoOdometry));
    case SectionStart::Turned:
    case SectionStart::TelemetryGap:
    case SectionStart::OdometryJump:
    case SectionStart::Cleared: break;
    }
    return {TR_NOOP("terratact::Estimation", "memory begins anew: %1"), describe(record_.why())};
}

Method methodWith(Method wanted, const SceneMemory& memory, const TrailInUse& networks)
{
    const bool isRemembered = memory.history && !networks.name.isEmpty();
    return wanted == Method::Trail && !isRemembered ? Method::Local : wanted;
}

}  // namespace terratact
