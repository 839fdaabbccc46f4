#pragma once

#include <array>
#include <optional>

#include "core/infer/estimate/estimate.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/strip/dead_reckoning.h"
#include "core/strip/height_band.h"

namespace terratact {

/// An estimate as seen from a later pose.
struct CarriedEstimate {
    /// Heights [m] in the DEM frame of the later pose; empty outside the estimate's bins.
    std::array<std::optional<HeightBand>, kBins> bin{};
    ImuMotion motion;  ///< since the estimate's scene
    bool operator==(const CarriedEstimate&) const = default;
};

/// Carries an estimate by dead reckoning, with the bins that rest on the training set alone. Heights, sd
/// and distances of the quantiles are interpolated linearly between the estimate's bins. Every bin
/// widens by w:
///   sd² → sd² + w²,   |q − height|² → |q − height|² + (1.28 w)²,
///   w² = (g · slipForward − slipUp)² + upSd²
/// g is the slope to a neighbour for which the first term is larger. No motion returns the estimate
/// unchanged.
CarriedEstimate carriedEstimate(const TerrainEstimate& estimate, const ImuMotion& motion);

/// Carries one estimate along the telemetry after its scene. It ends for good at one of these:
///   - a line without odometry, or more than kMaxSilence [s] between two lines
///   - a way of more than kWay
///   - a change of pitch or roll of more than kTilt, or of heading of more than kTurn
///   - no bin has an sd of at most kSd
class EstimateCarrier {
public:
    static constexpr double kWay = 1.0;    ///< [m] rolled by the tracks
    static constexpr double kSd = 0.15;    ///< [m]
    static constexpr double kTilt = 0.35;  ///< [rad]
    static constexpr double kTurn = 0.10;  ///< [rad]

    /// scene: the telemetry behind the estimate. It may be old, because the robot does not move during
    /// estimates and probes.
    EstimateCarrier(const RobotModel& robot, const TerrainEstimate& estimate,
                    const Measurement& scene);

    /// Adds the next line of telemetry. Does nothing after the end.
    void add(const Measurement& line);

    /// Returns the estimate as seen from the newest line; empty after the end.
    const std::optional<CarriedEstimate>& carried() const { return carried_; }

private:
    bool isWithinLimits(const Measurement& line) const;

    TerrainEstimate estimate_;
    Measurement scene_;
    std::optional<double> newest_;  ///< time of the newest line [s]
    std::optional<DeadReckoning> reckoning_;
    std::optional<CarriedEstimate> carried_;
};

}  // namespace terratact
