#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "app/modelling/simulation/driven_grounds.h"
#include "core/eval/evaluation.h"
#include "core/sim/fault_trial.h"
#include "core/sim/watched_drive.h"

namespace terratact {

/// Drives of a trial of sensor faults.
struct FaultTrial {
    DrivenGrounds grounds{};  ///< its seed is also that of styles, slip and noise
    int drives = 40;          ///< number over random ground; maximum of a file's profiles
    double spacing = 0.3;     ///< [m] distance between two scenes
    bool comesBack = false;   ///< every drive turns at its end and drives back
    Settings settings{};      ///< of the estimates
};

/// Drives without a fault, line by line.
using WatchedDrives = std::vector<std::vector<WatchedLine>>;

/// [m] A drive with a shorter way back did not come back: the robot tipped over, or got stuck.
inline constexpr double kMinWayBack = 3.0;

struct FaultDrives {
    WatchedDrives drives;     ///< at least one
    std::size_t leftOut = 0;  ///< drives that were to come back, but did not
};

/// Drives the simulated robot over the grounds, on all cores (core/sim/watched_drive.h). A drive that did not come back
/// is replaced by one over another ground. There are twice as many grounds as drives for that. Errors: those of the
/// file; no drive came back.
Result<FaultDrives> driveForFaults(const RobotModel& robot, const FaultTrial& trial);

/// Result of one fault on all drives.
struct FaultCounts {
    std::size_t drives = 0, scenes = 0;
    std::size_t suspects = 0;       ///< scenes under suspicion
    std::size_t contradicting = 0;  ///< scenes whose estimate contradicts the readings
    std::size_t doubted = 0;        ///< suspects, and scenes whose verdict is withheld or absent
    std::vector<double> seconds{};  ///< [s] until the first suspicion, per drive with one
    std::vector<double> scenesUntil{};      ///< scenes until then
    std::vector<BinError> errors{};         ///< of all scenes
    std::vector<BinError> trustedErrors{};  ///< of the scenes that are not doubted
};

/// Applies a fault to the telemetry of the drives. Estimates every scene with it, checks the estimate against the
/// readings and judges its verdict with kStepLimit.
FaultCounts tryFault(const TriedFault& fault, const FaultTrial& trial,
                     const EstimatorBundle& bundle, const WatchedDrives& drives);

/// Returns the share of drives [%] in which SensorWatch detects the fault (sensorFaultFrom()).
double noticedPercent(std::string_view fault, const RobotModel& robot, const WatchedDrives& drives);

/// Returns 100 · part / whole; 0 if the whole is 0.
double sharePercent(std::size_t part, std::size_t whole);

/// Returns the lower median over all drives, of which those without a value count as infinite. Empty if fewer than half
/// of the drives have a value.
std::optional<double> medianOfDrives(std::vector<double> values, std::size_t drives);

/// Returns true if a fault adds more than 5 mm to the mean error. Also true if it lowers the coverage of the 80 % band
/// by more than 10 points. sound: result without a fault.
bool harms(const FaultCounts& fault, const FaultCounts& sound);

/// Returns true if 90 % of the scenes are doubted, or the fault is detected in 90 % of the drives.
bool isFlagged(const FaultCounts& fault);

}  // namespace terratact
