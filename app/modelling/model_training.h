#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/learn/data/bin_set.h"
#include "core/learn/model/model.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// What a model is trained from.
struct TrainingPlan {
    RobotModel robot;
    std::string data;        ///< scenes CSV with all heights
    double scannerSd = 0.0;  ///< [m] of noise added to the conditionals' heights
    int conditionalRows = 1400;
    int inducing = 0;         ///< rows the conditionals predict through, at most; 0: all
    std::string commandLine;  ///< kept in the model
    std::uint64_t seed = 1;
    std::optional<BinSet> bins{};  ///< empty: all; else the model is a part, for writeModelPart
    int threads = 0;               ///< at most; 0: one per processor
};

/// Scenes above which whoever trains exact conditionals is told of inducing rows (docs/speed.md: what they save and err).
inline constexpr int kManyRows = 3000;

/// What is learnt for every bin, in this order, two kinds side by side.
enum class TrainingKind : std::uint8_t {
    Paf,               ///< p(hᵢ | h_{J∖i}, s), s with currents and forces
    Pa,                ///< without
    SurfaceCovered,    ///< the bin's surface given s, where the robot is above it
    SurfaceOpen,       ///< elsewhere
    ClearanceCovered,  ///< p(yᵢ | y_{J∖i}, s) over clearances
    ClearanceOpen,
};
inline constexpr std::array kTrainingKinds{TrainingKind::Paf,
                                           TrainingKind::Pa,
                                           TrainingKind::SurfaceCovered,
                                           TrainingKind::SurfaceOpen,
                                           TrainingKind::ClearanceCovered,
                                           TrainingKind::ClearanceOpen};

/// What two kinds are called while they are trained: "Gaussian process", "surface", "clearance".
std::string_view stageOf(TrainingKind kind);

enum class TrainingEvent : std::uint8_t {
    Begun,
    Done,
    Skipped,  ///< too few scenes in that regime: the model does without
};

/// One bin of one kind begins or ends.
struct TrainingStep {
    TrainingKind kind = TrainingKind::Paf;
    int bin = 0;
    TrainingEvent event = TrainingEvent::Begun;
    std::optional<double>
        logLikelihood;   ///< log p(y | X) of the search's last rows, where it is kept
    int stageTotal = 0;  ///< bins × kinds of this stage
    double share = 0.0;  ///< 0 … 1 of the work of all stages that is done, estimated
};

/// How training talks to whoever waits; all may be empty.
struct TrainingWatch {
    std::function<bool()> cancelled;                    ///< from any thread, every few milliseconds
    std::function<void(const TrainingStep&)> progress;  ///< by one thread at a time
    std::function<void(const std::string&)> notice;     ///< something about the file, a sentence
};

/// Trains a model; it is whole unless the plan names bins.  Same plan but for threads and
/// the same machine: the same model.  Errors name the file, and its line where it has one.
/// Throws Cancelled (core/infer/sampling/watch.h) once watch.cancelled() says so.
Result<ModelData> trainModel(const TrainingPlan& plan, const TrainingWatch& watch = {});

}  // namespace terratact
