#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/infer/estimator.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/log/session_reader.h"

namespace terratact {

// Recomputes recorded estimates, with their own or with other settings and models.

/// Returns the robot of a session. Errors name the session's file.
Result<RobotModel> robotOf(const SessionReader& session);

/// Returns the first of `paths` whose SHA-256 is that of the row. The Error lists the files tried.
Result<std::string> modelFileOf(const ModelRow& row, std::span<const std::string> paths);

/// Returns a recorded estimate with its draws. Errors name the session's file.
Result<TwoTrackEstimate> recordedEstimate(SessionReader& session, const EstimateRow& row);

/// What-if: recomputes the estimate of the row's scene by estimateMeasured(), like the console. It uses the
/// session's robot and the scene's probe readings in their order. models: for that robot. Errors name the
/// session's file; settings above requireModest() are errors. Throws Cancelled. With the row's own model
/// and settings the result is bit-identical to the recording. This needs the same version and vector
/// instructions, one BLAS thread, and a sampling that time did not end (Ending::Time). Otherwise
/// Match::LastBits may result.
Result<TwoTrackEstimate> estimateAgain(const SessionReader& session, const EstimateRow& row,
                                       const Models& models, const Settings& settings,
                                       const Watch& watch = {});

/// Returns an Error that names a setting with which an estimate would take days: settings come from a file. The bounds
/// are far above all usual settings.
Status requireModest(const Settings& settings);
inline constexpr int kMaxChainsAgain = 4096;
/// Kept and discarded sweeps of all chains.
inline constexpr std::int64_t kMaxSweepsAgain = 2'000'000;

/// Change of one bin, after − before [m].
struct BinDifference {
    double mean = 0.0, sd = 0.0, q10 = 0.0, q90 = 0.0, height = 0.0;
    bool operator==(const BinDifference&) const = default;
};

/// Tolerance between estimates computed alike: [m], and relative for numbers beyond 1. Other vector instructions, or
/// another order of summation in a later version, cause such differences.
inline constexpr double kLastBits = 1e-6;

/// Match of two estimates. Settings count only through the verdict. The oldest sessions do not record touches; touches
/// and verdict are then not compared.
enum class Match {
    /// Every number of both sides, draws included, is bit-identical. Touch, missing sensors, texts, the posterior check
    /// and the verdict are equal.
    Identical,
    LastBits,  ///< every number differs by at most kLastBits; all else is equal
    Other
};

struct Differences {
    /// Left, right. They are equal if both estimates are of one plane.
    std::array<std::array<BinDifference, kBins>, 2> side{};
    bool onePlane = true;         ///< both estimates are of one plane
    std::size_t largestSide = 0;  ///< side and bin with the largest change of height
    int largestBin = 0;
    TwoTrackVerdict before, after;  ///< without telemetry gaps
    Match match = Match::Other;
    double largest() const;  ///< [m] |height change| of largestSide and largestBin
};

/// robot: of the session. stepLimit: obstacle height of the verdicts [m]. Throws the exceptions of verdictOf().
Differences differencesBetween(const TwoTrackEstimate& before, const TwoTrackEstimate& after,
                               const RobotModel& robot, const Measurement& scene, double stepLimit);

}  // namespace terratact
