#pragma once

#include <QDateTime>
#include <QObject>
#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/eval/estimate_error.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/robot/measurement.h"
#include "core/robot/probe_side.h"

namespace terratact {

class Exploration;

/// An estimate of this run as it was when it was ready. Its draws are not kept.
struct PastEstimate {
    std::int64_t number = 0;  ///< counts from 1
    QDateTime at{};
    std::shared_ptr<const TwoTrackEstimate> estimate{};
    Measurement scene{};
    std::optional<Heights> truth{};
    std::optional<std::array<Heights, 2>> sideTruth{};  ///< left, right
    std::optional<TwoTrackVerdict> verdict{};           ///< at that time
    double stepLimit = 0.0;                             ///< of the verdict [m]
    bool hasReading = false;                            ///< made with a reading of the arm
    /// Error against the truth of a simulated source: of one plane, or left and right. Empty: not known.
    std::vector<EstimateError> errors{};
    /// A height that the arm measured later in the same scene, and the estimate's error there.
    struct Probed {
        ProbePlace place{};
        double error = 0.0;  ///< [m] height − measured height
        bool operator==(const Probed&) const = default;
    };
    std::vector<Probed> probed{};
    bool isHidden = false;    ///< the operator has hidden it
    bool isRestored = false;  ///< hidden and brought back, so it is from before
};

/// The estimates of scenes since the console started, newest first, at most kMaxKept: below 2 MB. It only listens, so
/// nothing here affects a verdict, a proposal or a command. GUI thread only.
class EstimateHistory final : public QObject {
    Q_OBJECT
public:
    static constexpr std::size_t kMaxKept = 200;

    /// exploration: must outlive the object.
    explicit EstimateHistory(const Exploration& exploration, QObject* parent = nullptr);

    const std::deque<PastEstimate>& entries() const { return entries_; }
    /// Returns an entry; null: it was dropped.
    const PastEstimate* entry(std::int64_t number) const;
    /// Returns the number of the estimate that stands; 0: none stands.
    std::int64_t present() const;

signals:
    void changed();

private:
    void addPresent();
    void score(const PastEstimate& with);

    const Exploration& exploration_;
    std::deque<PastEstimate> entries_;
    std::int64_t last_ = 0;  ///< newest number
};

}  // namespace terratact
