#include "app/plotting/telemetry_signals.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace terratact {
namespace {

struct TelemetryEntry {
    const char* id;
    SourceText name;
    const char* unit;
    std::optional<double> (*value)(const Measurement&);
};

std::optional<double> unlessMissing(const Measurement& m, std::size_t feature, double value)
{
    return m.missing.test(feature) ? std::nullopt : std::optional(value);
}

constexpr const char* kRadians = "rad";
constexpr const char* kAmperes = "A";
constexpr std::array kTelemetryEntries{
    TelemetryEntry{"pitch", TR_NOOP("core", "pitch"), kRadians,
                   [](const Measurement& m) { return std::optional(m.pitch); }},
    TelemetryEntry{"roll", TR_NOOP("core", "roll"), kRadians,
                   [](const Measurement& m) { return std::optional(m.roll); }},
    TelemetryEntry{"front_left", TR_NOOP("core", "front flipper left"), kRadians,
                   [](const Measurement& m) { return std::optional(m.frontLeft); }},
    TelemetryEntry{"front_right", TR_NOOP("core", "front flipper right"), kRadians,
                   [](const Measurement& m) { return std::optional(m.frontRight); }},
    TelemetryEntry{"rear_left", TR_NOOP("core", "rear flipper left"), kRadians,
                   [](const Measurement& m) { return std::optional(m.rearLeft); }},
    TelemetryEntry{"rear_right", TR_NOOP("core", "rear flipper right"), kRadians,
                   [](const Measurement& m) { return std::optional(m.rearRight); }},
    TelemetryEntry{"front_current_left", TR_NOOP("core", "front current left"), kAmperes,
                   [](const Measurement& m) { return motorCurrents(m)[0]; }},
    TelemetryEntry{"front_current_right", TR_NOOP("core", "front current right"), kAmperes,
                   [](const Measurement& m) { return motorCurrents(m)[1]; }},
    TelemetryEntry{"rear_current_left", TR_NOOP("core", "rear current left"), kAmperes,
                   [](const Measurement& m) { return motorCurrents(m)[2]; }},
    TelemetryEntry{"rear_current_right", TR_NOOP("core", "rear current right"), kAmperes,
                   [](const Measurement& m) { return motorCurrents(m)[3]; }}};

constexpr std::array kTelemetryTail{
    TelemetryEntry{"travelled", TR_NOOP("core", "way of the tracks"), "m",
                   [](const Measurement& m) { return m.travelled; }},
    TelemetryEntry{"turned", TR_NOOP("core", "turn of the tracks"), kRadians,
                   [](const Measurement& m) { return m.turned; }},
    TelemetryEntry{"differential", TR_NOOP("core", "differential"), kRadians,
                   [](const Measurement& m) { return m.differential; }}};

constexpr std::size_t kForces = static_cast<std::size_t>(kForceElements);
constexpr std::size_t kTail = kTelemetryEntries.size() + kForces;
constexpr std::size_t kSideForces = kTail + kTelemetryTail.size();
static_assert(kSideForces == kEverySignals && kTail == kSensorSignals);

struct SidePlace {
    const char* id;
    SourceText name;
};
constexpr std::array kSidePlaces{
    SidePlace{"front_left_force", TR_NOOP("core", "force %1, front left")},
    SidePlace{"front_right_force", TR_NOOP("core", "force %1, front right")},
    SidePlace{"rear_left_force", TR_NOOP("core", "force %1, rear left")},
    SidePlace{"rear_right_force", TR_NOOP("core", "force %1, rear right")}};

std::vector<PlotSignal> madeTelemetrySignals()
{
    std::vector<PlotSignal> made;
    made.reserve(kSideForces + kSidePlaces.size() * kForces);
    const auto add = [&made](std::string id, Message called, const char* unit) {
        made.push_back({SignalOrigin::Telemetry, std::move(id), std::move(called), unit, {}});
    };
    for (const TelemetryEntry& entry : kTelemetryEntries) add(entry.id, entry.name, entry.unit);
    for (std::size_t e = 1; e <= kForces; ++e)
        add("force" + std::to_string(e), {TR_NOOP("core", "force %1"), e}, "N");
    for (const TelemetryEntry& entry : kTelemetryTail) add(entry.id, entry.name, entry.unit);
    for (const SidePlace& place : kSidePlaces)
        for (std::size_t e = 1; e <= kForces; ++e)
            add(place.id + std::to_string(e), {place.name, e}, "N");
    return made;
}

std::optional<double> sideForce(std::size_t index, const Measurement& m)
{
    const std::size_t element = index % kForces;
    switch (index / kForces) {
    case 0: return m.sides.left.at(element);
    case 1: return m.sides.right.at(element);
    case 2: return m.rearSides.left.at(element);
    default: return m.rearSides.right.at(element);
    }
}

}  // namespace

std::span<const PlotSignal> telemetrySignals()
{
    static const std::vector<PlotSignal> kSignals = madeTelemetrySignals();
    return kSignals;
}

std::optional<double> telemetryValue(std::size_t index, const Measurement& measurement)
{
    if (index < kTelemetryEntries.size()) return kTelemetryEntries[index].value(measurement);
    if (index < kTail) {
        const std::size_t element = index - kTelemetryEntries.size();
        return unlessMissing(measurement, kFirstForceFeature + element,
                             measurement.force.at(element));
    }
    if (index < kSideForces) return kTelemetryTail[index - kTail].value(measurement);
    if (index >= telemetrySignals().size())
        throw std::out_of_range("telemetryValue: there is no such signal");
    return sideForce(index - kSideForces, measurement);
}

}  // namespace terratact
