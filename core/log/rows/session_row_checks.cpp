#include "core/log/rows/session_row_checks.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/log/rows/session_memory.h"

namespace terratact {
namespace {

void requireAllFinite(const Heights& heights)
{
    for (const double height : heights) requireFinite({height});
}

void requireFiniteSide(const TerrainEstimate& e)
{
    const Settings& s = e.settings;
    requireFinite({e.novelty, s.forceThreshold, s.contactSd, s.probeAbove, s.rollLimit,
                   s.asymmetryLimit, s.hazardRate, e.feltTo});
    for (const double ceiling : e.ceiling)
        if (!std::isinf(ceiling)) requireFinite({ceiling});
    for (const Heights* values : {&e.mean, &e.sd, &e.q10, &e.q90, &e.height, &e.rhat, &e.ess})
        requireAllFinite(*values);
    for (const Heights& draw : e.draws) requireAllFinite(draw);
}

}  // namespace

void requireFinite(std::initializer_list<double> values)
{
    for (const double value : values)
        if (!std::isfinite(value))
            throw std::invalid_argument("SessionWriter: a number that is not finite");
}

void requireFinite(const SceneRow& row)
{
    const Measurement& m = row.measurement;
    requireFinite({m.time, m.pitch, m.roll, m.frontLeft, m.frontRight, m.rearLeft, m.rearRight,
                   m.frontLeftCurrent, m.frontRightCurrent, m.rearLeftCurrent, m.rearRightCurrent,
                   m.travelled.value_or(0.0), m.turned.value_or(0.0)});
    for (const double force : m.force) requireFinite({force});
    requireFinite({m.differential.value_or(0.0)});
    for (const SideForces& sides : {m.sides, m.rearSides})
        for (const auto& side : {sides.left, sides.right})
            for (const auto& force : side) requireFinite({force.value_or(0.0)});
    if (m.arm) requireFinite({m.arm->height, m.arm->sd});
    if (row.memory && !memoryFrom(bytesOfMemory(*row.memory)))
        throw std::invalid_argument("SessionWriter: a memory of the way out of its ranges");
    if (row.truth) requireAllFinite(*row.truth);
    if (row.sideTruth)
        for (const Heights& side : *row.sideTruth) requireAllFinite(side);
}

void requireFinite(const EstimateRow& row)
{
    requireFinite({row.seconds, row.stepLimit});
    for (const TerrainEstimate& side : row.estimate.side) requireFiniteSide(side);
    for (const ArmReading& reading : row.readings) requireFinite({reading.height, reading.sd});
}

void requireSides(const EstimateRow& row)
{
    const auto& [left, right] = row.estimate.side;
    const auto require = [&row](bool holds, const char* expected) {
        if (!holds)
            throw std::invalid_argument("SessionWriter: estimate " + std::to_string(row.id) + ": "
                                        + expected);
    };
    require(left.settings == right.settings, "both sides must have the same settings");
    require(left.draws.size() == right.draws.size(),
            "both sides must have the same number of draws");
    require(!row.estimate.onePlane || left == right, "both sides of one plane must be equal");
}

void requireFinite(const ProposalRow& row)
{
    requireFinite({row.height, row.q10, row.q90, row.sd, row.limit, row.armSd, row.seconds,
                   row.stepLimit, row.bitsBefore});
    for (const OfferedBin& offer : row.offers)
        requireFinite({offer.varianceShare, offer.bitsAfter});
}

void requireNext(std::int64_t id, std::int64_t& last)
{
    if (id <= last)
        throw std::invalid_argument("SessionWriter: an id that is not larger than the last");
    last = id;
}

void requireKnown(std::int64_t id, std::int64_t last, bool mayBeNone)
{
    if (id > last || id < 0 || (id == 0 && !mayBeNone))
        throw std::invalid_argument("SessionWriter: a row refers to one that was not added");
}

}  // namespace terratact
