#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/infer/estimator.h"
#include "core/infer/verdict/verdict.h"
#include "core/log/session_reader.h"

namespace terratact {

// Recorded estimates, computed again: as they were, or with other settings or another model.

/// The robot of a session.  Errors name the session's file.
Result<RobotModel> robotOf(const SessionReader& session);

/// The first of `paths` whose file's SHA-256 is the row's.  Errors say what was looked at: there is none.
Result<std::string> modelFileOf(const ModelRow& row, std::span<const std::string> paths);

/// A recorded estimate with its draws.  Errors name the session's file.
Result<TerrainEstimate> recordedEstimate(SessionReader& session, const EstimateRow& row);

/// The estimate of the row's scene with its readings, in their order, and the session's robot.  With the row's
/// own model and settings that is the recorded one, bit for bit, unless time had ended its sampling
/// (Ending::Time), with the same version on a machine with the same vector instructions and with BLAS in one thread, as
/// our programs have it; else Match::LastBits may be left.
/// models: for that robot.  Errors name the session's file: among others settings that are not modest.  Throws
/// Cancelled.
Result<TerrainEstimate> estimateAgain(const SessionReader& session, const EstimateRow& row,
                                      const Models& models, const Settings& settings,
                                      const Watch& watch = {});

/// Whether these settings may be computed: a file can ask for days of computing.  Far more than the console has ever
/// recorded is refused with a sentence that names the setting.
Status requireModest(const Settings& settings);
inline constexpr int kMaxChainsAgain = 4096;
inline constexpr std::int64_t kMaxSweepsAgain = 2'000'000;  ///< kept and thrown away, of all chains

/// How far one bin moved, after − before [m].
struct BinDifference {
    double mean = 0.0, sd = 0.0, q10 = 0.0, q90 = 0.0, height = 0.0;
    bool operator==(const BinDifference&) const = default;
};

/// Of [m], and of numbers beyond 1 as a share: what other vector instructions, or sums in another order by a later version,
/// may leave between two estimates that are otherwise computed alike.
inline constexpr double kLastBits = 1e-6;

enum class Match {
    Identical,  ///< every number, bit for bit, the draws among them, and every word
    LastBits,   ///< every number within kLastBits, and every word
    Other
};

struct Differences {
    std::array<BinDifference, kBins> bin{};
    int largestBin = 0;     ///< where the height moved most
    Verdict before, after;  ///< as if the robot were heard
    Match likeness = Match::Other;
    double largest() const;  ///< [m] |height| of largestBin
};

/// stepLimit: [m] of the verdicts.  Throws as verdictOf does.
Differences differencesBetween(const TerrainEstimate& before, const TerrainEstimate& after,
                               const Measurement& scene, double stepLimit);

}  // namespace terratact
