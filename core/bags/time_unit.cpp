#include "core/bags/time_unit.h"

#include <array>
#include <cmath>

namespace terratact {
namespace {

constexpr std::array<TimeUnit, 4> kTimeUnits{
    {{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}};
constexpr double kFirstDay = 9.8e8, kLastDay = 4.1e9;      // [s] since 1970: 2001 to 2099
constexpr double kMinStep = 1e-6, kMaxStep = 2.0;          // [s] between samples of a recording
constexpr double kSecondsUpTo = 1.0, kThousandth = 500.0;  // units of a step

bool isRecorded(const TimeUnit& unit, double first, double step)
{
    const double day = first * unit.seconds, wait = step * unit.seconds;
    return day >= kFirstDay && day <= kLastDay
        && (step == 0.0 || (wait >= kMinStep && wait <= kMaxStep));
}

}  // namespace

TimeUnit timeUnitOf(double first, double step)
{
    for (const TimeUnit& unit : kTimeUnits)
        if (isRecorded(unit, std::abs(first), step)) return unit;
    if (step <= kSecondsUpTo) return kTimeUnits[0];
    if (step < kThousandth) return kTimeUnits[1];
    return step < 1e3 * kThousandth ? kTimeUnits[2] : kTimeUnits[3];
}

}  // namespace terratact
