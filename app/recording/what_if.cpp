#include "app/recording/what_if.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "core/base/text.h"
#include "core/infer/estimate/felt_horizon.h"
#include "core/infer/two_track_estimator.h"
#include "core/sim/two_track_check.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"

namespace terratact {

namespace {

bool sameBits(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool nearly(double a, double b)
{
    return sameBits(a, b)
        || std::abs(a - b) <= kLastBits * std::max({1.0, std::abs(a), std::abs(b)});
}

/// Compares numbers, arrays of numbers and lists of them.
template <bool same(double, double)>
struct Alike {
    bool operator()(double a, double b) const { return same(a, b); }

    template <class Numbers>
    bool operator()(const Numbers& a, const Numbers& b) const
    {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), *this);
    }
};

bool areTouchesRecorded(const TerrainEstimate& a, const TerrainEstimate& b)
{
    return isTouchRecorded(a) && isTouchRecorded(b);
}

/// Compares the touch, which the oldest sessions did not record.
template <class Same>
bool alikeInTouch(const TerrainEstimate& a, const TerrainEstimate& b, Same same)
{
    return !areTouchesRecorded(a, b) || (a.touch == b.touch && same(a.feltTo, b.feltTo));
}

/// Compares everything except the settings, which describe how the estimate was made.
template <class Same>
bool alike(const TerrainEstimate& a, const TerrainEstimate& b, Same same)
{
    return alikeInTouch(a, b, same) && a.missing == b.missing && a.contradicts == b.contradicts
        && same(a.mean, b.mean) && same(a.sd, b.sd) && same(a.q10, b.q10) && same(a.q90, b.q90)
        && same(a.height, b.height) && same(a.ceiling, b.ceiling) && a.origin == b.origin
        && same(a.rhat, b.rhat) && same(a.ess, b.ess) && same(a.draws, b.draws)
        && same(a.novelty, b.novelty) && a.ending == b.ending && a.converged == b.converged
        && english(a.warnings, "\n") == english(b.warnings, "\n");
}

/// Compares both sides.
template <class Same>
bool alike(const TwoTrackEstimate& a, const TwoTrackEstimate& b, Same same)
{
    return a.onePlane == b.onePlane && alike(a.side[0], b.side[0], same)
        && alike(a.side[1], b.side[1], same);
}

Match matchOf(const TwoTrackEstimate& a, const TwoTrackEstimate& b)
{
    if (alike(a, b, Alike<sameBits>{})) return Match::Identical;
    return alike(a, b, Alike<nearly>{}) ? Match::LastBits : Match::Other;
}

/// Returns true if both verdicts answer the same. Where the touch is not recorded, a verdict has another meaning.
bool answerAlike(const Differences& d, const TwoTrackEstimate& before,
                 const TwoTrackEstimate& after)
{
    for (std::size_t k = 0; k < 2; ++k) {
        if (!areTouchesRecorded(before.side.at(k), after.side.at(k))) return true;
        if (d.before.side.at(k).stepVerdict != d.after.side.at(k).stepVerdict) return false;
    }
    return d.before.both == d.after.both;
}

}  // namespace

Result<RobotModel> robotOf(const SessionReader& session)
{
    Result<RobotModel> robot = robotModelFrom("its robot", session.start().robot);
    if (robot) return robot;
    const Message& cause = robot.error().message.arguments.back();  // behind the name
    return fileError(session.path(), Message::joined(TR_NOOP("core", "its robot"), cause));
}

Result<std::string> modelFileOf(const ModelRow& row, std::span<const std::string> paths)
{
    Message missing(TR_NOOP("core", "the session's model %1 (%2…) is not there"), shown(row.name),
                    row.hash.substr(0, 12));
    for (const std::string& path : paths) {
        const auto hash = sha256OfFile(path);
        if (hash && *hash == row.hash) return path;
        const Message seen = hash ? Message(TR_NOOP("core", "%1 is %2…"), path, hash->substr(0, 12))
                                  : hash.error().message;
        missing = Message(TR_NOOP("core", "%1; %2"), missing, seen);
    }
    return Error{std::move(missing)};
}

Result<TwoTrackEstimate> recordedEstimate(SessionReader& session, const EstimateRow& row)
{
    auto draws = session.draws(row.id);
    if (!draws) return draws.error();
    TwoTrackEstimate estimate = row.estimate;
    setDraws(estimate, std::move(*draws));
    return estimate;
}

Status requireModest(const Settings& settings)
{
    if (settings.chains > kMaxChainsAgain)
        return Error{Message(TR_NOOP("core", "its settings need %1 chains; the limit is %2"),
                             settings.chains, kMaxChainsAgain)};
    const std::int64_t thrownAway = std::int64_t{settings.chains} * settings.burnIn;
    if (thrownAway + settings.draws > kMaxSweepsAgain)
        return Error{Message(TR_NOOP("core", "its settings need %1 kept and %2 discarded sweeps; "
                                             "the limit is %3 in total"),
                             settings.draws, thrownAway, kMaxSweepsAgain)};
    return Done{};
}

Result<TwoTrackEstimate> estimateAgain(const SessionReader& session, const EstimateRow& row,
                                       const Models& models, const Settings& settings,
                                       const Watch& watch)
{
    const auto robot = robotOf(session);
    if (!robot) return robot.error();
    const SceneRow* scene = session.scene(row.scene);
    if (!scene)
        return fileError(session.path(),
                         Message(TR_NOOP("core", "estimate %1: its scene is not there"), row.id));
    if (const Status modest = requireModest(settings); !modest)
        return fileError(session.path(), Message(TR_NOOP("core", "estimate %1: %2"), row.id,
                                                 modest.error().message));
    try {
        TwoTrackEstimate estimate =
            estimateMeasured(scene->measurement, row.readings, *robot, models, settings, watch,
                             scene->memory ? &*scene->memory : nullptr);
        writePosteriorCheck(estimate, scene->measurement, *robot, pollOf(watch));
        return estimate;
    } catch (const std::exception& refused) {  // the recorded scene cannot be estimated
        return fileError(session.path(),
                         Message(TR_NOOP("core", "estimate %1: %2"), row.id, refused.what()));
    }
}

double Differences::largest() const
{
    return std::abs(side.at(largestSide).at(static_cast<std::size_t>(largestBin)).height);
}

Differences differencesBetween(const TwoTrackEstimate& before, const TwoTrackEstimate& after,
                               const RobotModel& robot, const Measurement& scene, double stepLimit)
{
    Differences result{.onePlane = before.onePlane && after.onePlane,
                       .before = verdictOf(before, robot, scene, {}, stepLimit),
                       .after = verdictOf(after, robot, scene, {}, stepLimit),
                       .match = matchOf(before, after)};
    if (!answerAlike(result, before, after)) result.match = Match::Other;
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t i = 0; i < kBins; ++i) {
            const TerrainEstimate &was = before.side.at(k), &is = after.side.at(k);
            result.side.at(k)[i] = {.mean = is.mean[i] - was.mean[i],
                                    .sd = is.sd[i] - was.sd[i],
                                    .q10 = is.q10[i] - was.q10[i],
                                    .q90 = is.q90[i] - was.q90[i],
                                    .height = is.height[i] - was.height[i]};
            if (std::abs(result.side.at(k)[i].height) <= result.largest()) continue;
            result.largestSide = k;
            result.largestBin = static_cast<int>(i);
        }
    return result;
}

}  // namespace terratact
