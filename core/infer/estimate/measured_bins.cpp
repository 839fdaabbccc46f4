#include "core/infer/estimate/measured_bins.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/terrain/kinematic_reconstruction.h"

namespace terratact {

namespace {

constexpr double kContradiction = 3.0;  // [sd] distance beyond which two measurements contradict

void addContacts(MeasuredBins& measured, const RobotModel& robot, const Proprioception& s,
                 const Settings& settings)
{
    KinematicReconstruction contacts = reconstructContacts(
        robot, s, settings.forceThreshold, settings.contacts == ContactRule::Isolated);
    for (std::size_t i = 0; i < kBins; ++i)
        if (contacts.height[i])
            measured.bin[i] =
                MeasuredHeight{*contacts.height[i], settings.contactSd, Origin::Contact};
    measured.warnings = std::move(contacts.warnings);
}

void flagDisagreement(MeasuredBins& measured, const ArmReading& reading)
{
    const auto& touched = measured.bin[static_cast<std::size_t>(reading.bin)];
    if (!touched || touched->origin != Origin::Contact) return;
    const double difference = std::abs(touched->height - reading.height);
    if (difference > kContradiction * std::hypot(touched->sd, reading.sd))
        measured.warnings.emplace_back(
            TR_NOOP("core", "contact and arm disagree about bin %1 m by %2 mm"),
            signedFixed(binCentre(reading.bin), 1), fixed(1000.0 * difference, 0));
}

void addReading(MeasuredBins& measured, const ArmReading& reading, const Heights& ceiling)
{
    if (reading.bin < 0 || reading.bin >= kBins || !std::isfinite(reading.height)
        || !(reading.sd > 0.0))
        throw std::invalid_argument(
            "an arm reading needs a bin 0 to 10, a finite height and a positive sd");
    const auto bin = static_cast<std::size_t>(reading.bin);
    flagDisagreement(measured, reading);
    measured.bin[bin] = MeasuredHeight{reading.height, reading.sd, Origin::Arm};
    if (reading.height > ceiling[bin] + kContradiction * reading.sd)
        measured.warnings.emplace_back(
            TR_NOOP("core", "the arm found bin %1 m %2 mm above the robot's own lower edge"),
            signedFixed(binCentre(reading.bin), 1),
            fixed(1000.0 * (reading.height - ceiling[bin]), 0));
}

}  // namespace

MeasuredBins measureBins(const RobotModel& robot, const Proprioception& s,
                         std::span<const ArmReading> arm, const Heights& ceiling,
                         const Settings& settings)
{
    MeasuredBins measured;
    if (usesForces(settings.method) && settings.contacts != ContactRule::None)
        addContacts(measured, robot, s, settings);
    for (const ArmReading& reading : arm) addReading(measured, reading, ceiling);
    return measured;
}

}  // namespace terratact
