#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/modelling/evaluation/scene_evaluation.h"
#include "core/eval/evaluation.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/learn/data/two_track_scene.h"

namespace terratact {

/// Ways to estimate a scene of two tracks.
///   Both     estimateTwoTracks(): as one plane where the scene is symmetric within its noise
///   Always   both sides whatever the symmetry
///   Plane    the one-plane model on the means of both sides, for both sides
///   PerSide  the one-plane model on each side's readings (core/infer/each_side.h)
/// Sampling methods have learnt one plane: Plane and PerSide alone.
enum class TrackApproach : std::uint8_t { Both, Always, Plane, PerSide };
inline constexpr std::array kTrackApproaches{TrackApproach::Both, TrackApproach::Always,
                                             TrackApproach::Plane, TrackApproach::PerSide};

/// Returns "two tracks", "always two", "one plane" or "one per side".
std::string_view name(TrackApproach approach);

/// Estimates of all scenes; empty: the scene cannot be estimated.
using TrackEstimates = std::vector<std::optional<TwoTrackEstimate>>;

/// Estimates all scenes on all cores. Scene k uses settings.seed + k.
TrackEstimates estimateTracks(TrackApproach approach, std::span<const TwoTrackScene> scenes,
                              const EstimatorBundle& bundle, const Settings& settings);

/// Places the robot on every estimate's ground (core/sim/two_track_check.h), on all cores. An estimate that contradicts
/// its scene's readings gets a warning. Returns the number of contradictions.
std::size_t checkTracks(std::span<const TwoTrackScene> scenes, const RobotModel& robot,
                        TrackEstimates& estimates);

/// Returns the error of a model that has no two tracks.
Error modelOfOnePlane(const std::string& path);

/// Classes of scenes. Within: |roll| and the flippers' differences are within the limits beyond
/// which one plane is doubtful (Settings). Symmetric: isSymmetric().
enum class TrackClass : std::uint8_t { All, Within, Beyond, Symmetric };
inline constexpr std::array kTrackClasses{TrackClass::All, TrackClass::Within, TrackClass::Beyond,
                                          TrackClass::Symmetric};
std::string_view name(TrackClass sceneClass);

/// One line of errors: bins −0.3 … 0.5 m of a class, or one bin of all scenes.
struct TrackErrors {
    TrackApproach approach = TrackApproach::Both;
    std::string what;  ///< the class, or the bin such as "+0.6 m"
    ErrorStatistics errors;
};

/// Forecasts of a step ahead.
struct TrackSteps {
    TrackApproach approach = TrackApproach::Both;
    std::size_t scenes = 0;
    double brierPerSide = 0.0, brierEither = 0.0;
    double forecastPerSide = 0.0, forecastEither = 0.0;  ///< mean probability
    double observedPerSide = 0.0, observedEither = 0.0;  ///< share of steps
};

/// Scores of all approaches, and how the scenes were handled.
struct TrackFindings {
    Method method = Method::Local;
    std::vector<TrackErrors> errors;
    std::vector<TrackSteps> steps;
    std::size_t scenes = 0, failed = 0;
    std::size_t asOnePlane = 0;  ///< scenes that TrackApproach::Both estimated as one plane
    std::size_t attitude = 0;    ///< scenes whose attitude withholds a verdict of one plane
    TruthShare truth{};          ///< of the measured truth in the errors of the first approach
    std::size_t novel = 0;       ///< scenes that the two tracks call unlike the training
    /// Processor time of one estimate by TrackApproach::Always; by PerSide, if the method samples.
    double milliseconds = 0.0;
};

/// Evaluates scenes of two tracks by options.settings and a method, on all cores. Throws RefusedInput
/// if the model has no two tracks and the method needs them.
TrackFindings evaluateTracks(const std::vector<TwoTrackScene>& scenes,
                             const EstimatorBundle& bundle, const EvaluateOptions& options,
                             Method method);

/// Returns |height − truth| [m] of both sides, bins −0.3 … 0.5 m of all scenes that can be
/// estimated. Uses TrackApproach::Always and settings.method, on all cores.
std::vector<double> sideErrors(const std::vector<TwoTrackScene>& scenes, const RobotModel& robot,
                               const Models& models, const Settings& settings);

/// Errors without some sensors, in the bins −0.3 … 0.5 m of all scenes, by TrackApproach::Always.
/// The first method of the options estimates; it must be Local or Joint.
struct TrackMissing {
    std::string lacks;
    ErrorStatistics errors;
};
std::vector<TrackMissing> evaluateMissing(const std::vector<TwoTrackScene>& scenes,
                                          const EstimatorBundle& bundle,
                                          const EvaluateOptions& options);

// Tables for the terminal [mm] and CSV files [m].
std::string tracksTable(const TrackFindings& findings);
std::string tracksCsv(std::span<const TrackFindings> methods);
std::string trackStepsCsv(std::span<const TrackFindings> methods);
std::string missingTable(const std::vector<TrackMissing>& missing);
std::string missingCsv(const std::vector<TrackMissing>& missing);

}  // namespace terratact
