#include "core/learn/data/columns.h"

#include <numbers>
#include <stdexcept>

#include "core/base/text.h"

namespace terratact {
namespace {

constexpr Column angle(std::string_view name)
{
    return {name, "rad", -std::numbers::pi, std::numbers::pi, TR_NOOP("core", "is it in degrees?")};
}
constexpr Column current(std::string_view name)
{
    return {name, "A", -kMaxSceneCurrent, kMaxSceneCurrent, TR_NOOP("core", "is it in mA?")};
}
constexpr Column force(std::string_view name)
{
    return {name, "N", 0.0, 1000.0, TR_NOOP("core", "is it raw or without its bias taken off?")};
}
constexpr Column height(std::string_view name)
{
    return {name, "m", -5.0, 5.0, TR_NOOP("core", "is it in mm?")};
}

constexpr Column heightSd(std::string_view name)
{
    return {name, "m", 0.0, 5.0, TR_NOOP("core", "is it in mm?")};
}

constexpr std::array<Column, kFeatures> kFeatureColumns{
    angle("pitch_rad"),        angle("front_rad"), angle("rear_rad"),  current("front_current_a"),
    current("rear_current_a"), force("force_1_n"), force("force_2_n"), force("force_3_n"),
    force("force_4_n"),        force("force_5_n"), force("force_6_n"),
};

constexpr std::array<Column, kBins> kHeightColumns{
    height("h_-0.3_m"), height("h_-0.2_m"), height("h_-0.1_m"), height("h_+0.0_m"),
    height("h_+0.1_m"), height("h_+0.2_m"), height("h_+0.3_m"), height("h_+0.4_m"),
    height("h_+0.5_m"), height("h_+0.6_m"), height("h_+0.7_m"),
};

constexpr std::array<Column, kBins> kHeightSdColumns{
    heightSd("sd_-0.3_m"), heightSd("sd_-0.2_m"), heightSd("sd_-0.1_m"), heightSd("sd_+0.0_m"),
    heightSd("sd_+0.1_m"), heightSd("sd_+0.2_m"), heightSd("sd_+0.3_m"), heightSd("sd_+0.4_m"),
    heightSd("sd_+0.5_m"), heightSd("sd_+0.6_m"), heightSd("sd_+0.7_m"),
};

}  // namespace

Message Column::refusal(double value) const
{
    return {TR_NOOP("core", "%1 is %2, beyond the range from %3 to %4 %5 (%6)"),
            name,
            value,
            least,
            most,
            unit,
            doubt};
}

std::span<const Column, kFeatures> featureColumns()
{
    return kFeatureColumns;
}

FeatureValues featureValues(const Proprioception& s)
{
    FeatureValues values{s.pitch, s.front, s.rear, s.frontCurrent, s.rearCurrent};
    for (std::size_t i = 0; i < s.force.size(); ++i) values[5 + i] = s.force[i];
    return values;
}

Proprioception proprioception(const FeatureValues& values)
{
    if (!values[0] || !values[1] || !values[2])
        throw std::invalid_argument("proprioception: pitch or a flipper angle is missing");
    Proprioception s{.pitch = *values[0],
                     .front = *values[1],
                     .rear = *values[2],
                     .frontCurrent = values[3],
                     .rearCurrent = values[4]};
    for (std::size_t i = 0; i < s.force.size(); ++i) s.force[i] = values[5 + i];
    return s;
}

std::span<const Column, kBins> heightColumns()
{
    return kHeightColumns;
}

std::span<const Column, kBins> heightSdColumns()
{
    return kHeightSdColumns;
}

}  // namespace terratact
