#include "app/modelling/simulation/hazard_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/robot/kinematics.h"
#include "core/sim/drive.h"
#include "core/sim/ground/random_draw.h"
#include "core/sim/ground/random_ground.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/two_track_drive.h"
#include "core/sim/way_drive.h"
#include "core/terrain/step.h"

namespace terratact {
namespace {

constexpr double kStops = 0.1;       // [m] distance between two scenes
constexpr double kBefore = 1.0;      // [m] judged ground before the hazard
constexpr double kBehind = 0.5;      // [m] ground behind the latest start of the hazard
constexpr double kFirstStop = 0.65;  // [m] see stopsOver()

/// Returns true if a scene stands near hazards. way: driven since the first stop [m].
bool isNearHazard(double way)
{
    const double x = kFirstStop + way;
    return x >= kHazardBegin - kBefore && x <= kHazardEnd + kBehind;
}

DriveConditions conditionsOn(const HazardGround& ground, std::mt19937_64& rng)
{
    DriveConditions conditions;
    conditions.noise.height = 0.0;
    if (ground.isSoft) conditions.ground = randomSoftGround(rng);
    return conditions;
}

std::vector<double> contactsOf(const RobotModel& robot, const RestPose& rest)
{
    const double origin = imuPosition(robot, rest.pose).x;
    std::vector<double> contacts;
    contacts.reserve(rest.contacts.size());
    for (const GroundContact& contact : rest.contacts) contacts.push_back(contact.point.x - origin);
    std::ranges::sort(contacts);
    return contacts;
}

}  // namespace

TerrainProfile hazardProfile(const HazardGround& ground, std::optional<Hazard> hazard,
                             std::mt19937_64& rng)
{
    if (hazard) return randomHazardTerrain(*hazard, ground.roughness, rng);
    if (ground.roughness > 0.0) return isoRoughness(ground.roughness, kRandomTerrainLength, rng);
    return flatTerrain(kRandomTerrainLength);
}

GroundLines hazardLines(const RobotModel& robot, const HazardGround& ground,
                        std::optional<Hazard> hazard, bool onBothSides, std::mt19937_64& rng)
{
    const std::vector<double> ys = groundYs(robot);
    if (hazard) {
        const HazardSide one = whole(rng, 0, 1) == 0 ? HazardSide::Left : HazardSide::Right;
        return randomHazardGround(*hazard, onBothSides ? HazardSide::Both : one, ground.roughness,
                                  ys, rng);
    }
    std::vector<GroundLine> lines;
    lines.reserve(ys.size());
    for (const double y : ys) lines.push_back({y, flatTerrain(kRandomTerrainLength)});
    if (ground.roughness > 0.0)
        addRoughness(lines, ground.roughness, uniform(rng, kMinCorrelation, kMaxCorrelation), rng);
    return GroundLines(std::move(lines));
}

std::vector<HazardScene> driveTowards(const RobotModel& robot, const HazardGround& ground,
                                      std::optional<Hazard> hazard, PressStyle style,
                                      std::mt19937_64& rng)
{
    const TerrainProfile terrain = hazardProfile(ground, hazard, rng);
    std::vector<std::vector<double>> contacts;
    DriveConditions conditions = conditionsOn(ground, rng);
    conditions.rested = [&](const RestPose& rest) { contacts.push_back(contactsOf(robot, rest)); };
    const DriveStyle drive = style == PressStyle::Random ? randomDriveStyle(rng) : DriveStyle{};
    int skipped = 0;
    std::vector<Scene> scenes = driveOver(robot, terrain, stopsOver(terrain, kStops), "hazard",
                                          drive, conditions, rng, skipped);
    std::vector<HazardScene> near;
    for (std::size_t k = 0; k < scenes.size(); ++k)
        if (isNearHazard(kDriveSpeed * scenes[k].time))
            near.push_back({std::move(scenes[k]), std::move(contacts[k])});
    return near;
}

std::vector<TwoTrackScene> driveTracksTowards(const RobotModel& robot, const HazardGround& ground,
                                              std::optional<Hazard> hazard, bool onBothSides,
                                              PressStyle style, std::mt19937_64& rng)
{
    const GroundLines lines = hazardLines(robot, ground, hazard, onBothSides, rng);
    const DriveConditions conditions = conditionsOn(ground, rng);
    const DriveStyle drive = style == PressStyle::Random ? randomDriveStyle(rng) : DriveStyle{};
    int skipped = 0;
    auto scenes = driveOver(robot, lines, stopsOver(lines, kStops), "hazard", drive, conditions,
                            rng, skipped);
    std::erase_if(
        scenes, [](const TwoTrackScene& scene) { return !isNearHazard(kDriveSpeed * scene.time); });
    return scenes;
}

DriveLines driveTracksAlong(const RobotModel& robot, const HazardGround& ground,
                            std::optional<Hazard> hazard, bool onBothSides, PressStyle style,
                            std::mt19937_64& rng)
{
    const GroundLines lines = hazardLines(robot, ground, hazard, onBothSides, rng);
    const DriveConditions conditions = conditionsOn(ground, rng);
    const DriveStyle drive = style == PressStyle::Random ? randomDriveStyle(rng) : DriveStyle{};
    int skipped = 0;
    return driveWay(robot, lines, "hazard", drive, {.spacing = kStops}, conditions, rng, skipped);
}

bool isNear(const Measurement& scene)
{
    return isNearHazard(scene.travelled.value_or(0.0));
}

Heights knownHeights(const OptionalHeights& truth)
{
    Heights heights{};
    for (std::size_t i = 0; i < kBins; ++i) heights[i] = truth[i].value();
    return heights;
}

bool isFlatTo(const Heights& truth, double stepLimit, int lastBin)
{
    if (hasStep(truth, stepLimit, 0, lastBin)) return false;
    const double rise = (truth[static_cast<std::size_t>(lastBin)] - truth[0]) / lastBin;
    for (int bin = 1; bin < lastBin; ++bin)
        if (std::abs(truth[static_cast<std::size_t>(bin)] - truth[0] - rise * bin) > kFlatWithin)
            return false;
    return true;
}

bool isPressedTo(const std::vector<double>& contacts, int lastBin)
{
    double from = binBegin(kFirstAhead);
    for (const double x : contacts) {
        if (x < from) continue;
        if (x >= binEnd(lastBin)) break;
        if (x - from > kMaxUnpressed) return false;
        from = x;
    }
    return binEnd(lastBin) - from <= kMaxUnpressed;
}

}  // namespace terratact
