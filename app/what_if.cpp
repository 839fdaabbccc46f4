#include "app/what_if.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <stdexcept>

#include "core/file_read.h"
#include "core/infer/reconstruct.h"
#include "core/learn/sha256.h"
#include "core/text.h"

namespace terratact {

namespace {

bool sameBits(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool sameBits(const Heights& a, const Heights& b)
{
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!sameBits(a[i], b[i])) return false;
    return true;
}

bool sameBits(const std::vector<Heights>& a, const std::vector<Heights>& b)
{
    if (a.size() != b.size()) return false;
    for (std::size_t k = 0; k < a.size(); ++k)
        if (!sameBits(a[k], b[k])) return false;
    return true;
}

/// All but the settings, which say how it came about.
bool identical(const TerrainEstimate& a, const TerrainEstimate& b)
{
    return sameBits(a.mean, b.mean) && sameBits(a.sd, b.sd) && sameBits(a.q10, b.q10)
        && sameBits(a.q90, b.q90) && sameBits(a.height, b.height) && sameBits(a.ceiling, b.ceiling)
        && a.origin == b.origin && sameBits(a.rhat, b.rhat) && sameBits(a.ess, b.ess)
        && sameBits(a.draws, b.draws) && sameBits(a.novelty, b.novelty) && a.ending == b.ending
        && a.converged == b.converged && a.warnings == b.warnings;
}

}  // namespace

Result<RobotModel> robotOf(const SessionReader& session)
{
    return robotModelFrom(session.path() + ": its robot", session.start().robot);
}

Result<std::string> modelFileOf(const ModelRow& row, std::span<const std::string> paths)
{
    std::string seen;
    for (const std::string& path : paths) {
        const auto hash = sha256OfFile(path);
        if (hash && *hash == row.hash) return path;
        seen += hash ? fmt::format("; {} is {:.12}…", path, *hash) : "; " + hash.error().text;
    }
    return Error{fmt::format("the session's model {} ({:.12}…) is not there{}", shown(row.name),
                             row.hash, seen)};
}

Result<TerrainEstimate> recordedEstimate(SessionReader& session, const EstimateRow& row)
{
    auto draws = session.draws(row.id);
    if (!draws) return draws.error();
    TerrainEstimate estimate = row.estimate;
    estimate.draws = std::move(*draws);
    return estimate;
}

Result<TerrainEstimate> estimateAgain(const SessionReader& session, const EstimateRow& row,
                                      const Models& models, const Settings& settings,
                                      const Watch& watch)
{
    const auto robot = robotOf(session);
    if (!robot) return robot.error();
    const SceneRow* scene = session.scene(row.scene);
    if (!scene)
        return fileError(session.path(),
                         fmt::format("estimate {}: its scene is not there", row.id));
    try {
        TerrainEstimate estimate = estimateTerrain(proprioception(scene->measurement), row.readings,
                                                   *robot, models, settings, watch);
        warnIfNotPlanar(estimate, scene->measurement);  // as the console does
        return estimate;
    } catch (const std::exception& refused) {  // what the file says cannot be estimated
        return fileError(session.path(), fmt::format("estimate {}: {}", row.id, refused.what()));
    }
}

double Differences::largest() const
{
    return std::abs(bin[static_cast<std::size_t>(largestBin)].height);
}

Differences differencesBetween(const TerrainEstimate& before, const TerrainEstimate& after,
                               const Measurement& scene, double stepLimit)
{
    Differences result{.before = verdictOf(before, scene, {}, stepLimit),
                       .after = verdictOf(after, scene, {}, stepLimit),
                       .identical = identical(before, after)};
    for (std::size_t i = 0; i < kBins; ++i) {
        result.bin[i] = {.mean = after.mean[i] - before.mean[i],
                         .sd = after.sd[i] - before.sd[i],
                         .q10 = after.q10[i] - before.q10[i],
                         .q90 = after.q90[i] - before.q90[i],
                         .height = after.height[i] - before.height[i]};
        if (std::abs(result.bin[i].height) > result.largest())
            result.largestBin = static_cast<int>(i);
    }
    return result;
}

}  // namespace terratact
