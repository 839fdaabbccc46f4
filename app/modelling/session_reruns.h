#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "app/recording/scene_origins.h"
#include "app/recording/what_if.h"
#include "core/base/result.h"
#include "core/eval/calibration_ledger.h"
#include "core/eval/evaluation.h"
#include "core/infer/estimate/quality_preset.h"
#include "core/log/session_reader.h"

namespace terratact {

/// Requested changes of recorded settings; empty: as recorded.
struct RerunChanges {
    std::optional<Method> method{};
    std::optional<QualityPreset> preset{};
    std::optional<double> threshold{};  ///< [N]
    std::optional<std::uint64_t> seed{};
};

/// One recorded estimate and its recomputation.
struct Rerun {
    const SessionReader* session = nullptr;
    EstimateRow row;  ///< with draws
    TwoTrackEstimate again;
    Differences differences;
    bool asRecorded = false;  ///< no change was requested

    /// Returns true if time ended the recorded sampling, which cannot be reproduced.
    bool endedByTime() const { return row.estimate.side[0].ending == Ending::Time; }
    /// Returns true if the recomputation should equal the recording, and does not.
    bool failed() const
    {
        return asRecorded && differences.match == Match::Other && !endedByTime();
    }
};

/// Calibration of the recorded and the recomputed bands against later measurements.
struct RerunLedgers {
    CalibrationLedger then, now;
    bool empty() const { return then.entries().empty() && now.entries().empty(); }
};

/// Errors of the recorded and the recomputed estimates against the truth.
struct RerunErrors {
    std::vector<BinError> then, now;
};

/// Recomputes the estimates of recorded sessions with the recorded or other settings, and compares them. A scene that
/// occurs in several sessions counts once.
class SessionReruns {
public:
    struct Options {
        std::int64_t estimate = 0;               ///< 0: all estimates
        std::vector<std::string> shippedModels;  ///< models to try: one may be the session's
        std::string model;                       ///< model to estimate with; empty: the session's
        RerunChanges changes{};
    };
    struct Hooks {
        std::function<void(const SessionReader&)> opened;  ///< a session was opened
        std::function<Watch(const EstimateRow&)>
            watch;  ///< progress and cancellation of one estimate
    };
    SessionReruns(Options options, Hooks hooks);

    /// Recomputes the estimates of one session file. Errors name the file: it is unreadable, a model is not found, or
    /// the requested estimate does not exist. Throws Cancelled.
    Status add(const std::string& file);

    /// Returns the reruns in the order of files and estimates.
    const std::vector<Rerun>& all() const { return reruns_; }
    /// Returns the opened sessions in the order of add().
    const std::vector<std::unique_ptr<SessionReader>>& sessions() const { return sessions_; }
    std::size_t sessionsWithReruns() const;
    std::size_t failed() const;  ///< number of reruns for which Rerun::failed() holds

    /// Returns the errors against the truth; empty if no source recorded it.
    RerunErrors errors() const;
    /// Returns the calibration against later probes of the same scene.
    RerunLedgers laterProbes(const SessionReader& session) const;
    /// Returns the calibration against contacts and probes at later poses. It uses the last estimate of each scene from
    /// which odometry is continuous.
    RerunLedgers laterPoses(SessionReader& session) const;

    /// Returns one CSV line per bin, side and rerun, below a header. `side` is "both" if both estimates are of one
    /// plane.
    std::string csv() const;

private:
    Status repeat(SessionReader& session, const EstimateRow& row);
    Result<std::string> modelPath(const SessionReader& session, const EstimateRow& row,
                                  bool& recordedOne) const;
    /// Only the method trail needs the networks beside the model: another one ignores a broken file.
    Result<const EstimatorBundle*> bundleOf(const RobotModel& robot, const std::string& robotText,
                                            const std::string& path, Method method);

    Options options_;
    Hooks hooks_;
    std::map<std::array<std::string, 3>, std::unique_ptr<EstimatorBundle>>
        bundles_;  ///< by robot, model file and networks, empty without them
    SceneOrigins origins_;
    std::vector<std::unique_ptr<SessionReader>> sessions_;
    std::vector<Rerun> reruns_;
};

/// Returns the sessions in a folder sorted by name; a file returns itself.
std::vector<std::string> sessionsAt(const std::string& path);

}  // namespace terratact
