#include "core/atem/probe/probe_grounds.h"

#include <concepts>

#include "core/store/canonical_bytes.h"
#include "core/store/sha256.h"

namespace terratact {
namespace {

template <class T>
void add(CanonicalBytes& bytes, T value)
{
    if constexpr (std::floating_point<T>)
        bytes.add(static_cast<double>(value));
    else
        bytes.add(static_cast<std::uint64_t>(value));
}

template <class... T>
void addAll(CanonicalBytes& bytes, const T&... values)
{
    (add(bytes, values), ...);
}

// A new member breaks the bindings below at compile time: it must be added here.
void add(CanonicalBytes& bytes, const ArmReading& reading)
{
    const auto& [bin, height, sd, side] = reading;
    addAll(bytes, bin, height, sd, side);
}

void addOptional(CanonicalBytes& bytes, const std::optional<double>& value)
{
    addAll(bytes, value.has_value(), value.value_or(0.0));
}

void add(CanonicalBytes& bytes, const SideForces& forces)
{
    const auto& [left, right] = forces;
    for (const auto& side : {left, right})
        for (const auto& force : side) addOptional(bytes, force);
}

void add(CanonicalBytes& bytes, const Measurement& scene)
{
    const auto& [time, pitch, roll, frontLeft, frontRight, rearLeft, rearRight, frontLeftCurrent,
                 frontRightCurrent, rearLeftCurrent, rearRightCurrent, force, activity, refusal,
                 arm, travelled, turned, missing, missingMotors, sides, rearSides, differential] =
        scene;
    addAll(bytes, time, pitch, roll, frontLeft, frontRight, rearLeft, rearRight, frontLeftCurrent,
           frontRightCurrent, rearLeftCurrent, rearRightCurrent);
    for (const double f : force) add(bytes, f);
    addAll(bytes, activity, refusal, arm.has_value());
    if (arm) add(bytes, *arm);
    addOptional(bytes, travelled);
    addOptional(bytes, turned);
    const unsigned long lacking = missing.to_ulong() | (missingMotors.to_ulong() << kFeatures);
    if (lacking != 0) add(bytes, lacking);
    add(bytes, sides);
    add(bytes, rearSides);
    addOptional(bytes, differential);
}

void add(CanonicalBytes& bytes, const Settings& settings)
{
    const auto& [method, ceiling, contacts, forceThreshold, contactSd, draws, stopEarly, chains,
                 burnIn, scan, precision, inducing, seed, probeAbove, rollLimit, asymmetryLimit,
                 hazardRate] = settings;
    addAll(bytes, method, ceiling, contacts, forceThreshold, contactSd, draws, stopEarly, chains,
           burnIn, scan, precision, inducing, seed, probeAbove, rollLimit, asymmetryLimit,
           hazardRate);
}

}  // namespace

std::string fingerprint(const ProbeGrounds& grounds)
{
    CanonicalBytes bytes;
    bytes.add(std::string_view("probe"));
    add(bytes, grounds.scene);
    add(bytes, grounds.readings.size());
    for (const ArmReading& reading : grounds.readings) add(bytes, reading);
    add(bytes, grounds.settings);
    add(bytes, grounds.wanted);
    bytes.add(std::string_view(grounds.model));
    addAll(bytes, grounds.bin, grounds.side);
    return sha256Hex(bytes.bytes());
}

}  // namespace terratact
