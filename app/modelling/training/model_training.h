#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/learn/data/bin_set.h"
#include "core/learn/model/model.h"
#include "core/learn/model/model_card.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Input and options of a training.
struct TrainingPlan {
    RobotModel robot;
    std::string data;                     ///< CSV of scenes with all heights
    std::vector<std::string> moreData{};  ///< more of them, behind the first
    std::string tracks{};  ///< CSV of scenes of two tracks; empty: the model learns one plane only
    std::vector<std::string> moreTracks{};  ///< more of them, behind the first
    /// Generated scenes, mixed to the real ones of `data` or `tracks`. Their weight has the smallest
    /// error on held-out real scenes (scene_mixing.h). Each file holds one plane or two tracks.
    std::vector<std::string> generated{};
    /// Model whose part of one plane is kept bit by bit. The new model learns from `tracks` only, and
    /// `data` is not read. Empty: `data` trains that part.
    std::string plane{};
    double scannerSd = 0.0;  ///< [m] sd of noise added to the conditionals' heights
    int conditionalRows = 1400;
    int inducing = 0;         ///< maximum inducing rows of the conditionals; 0: exact
    std::string commandLine;  ///< stored in the model
    std::uint64_t seed = 1;
    /// Empty: all bins. Otherwise the model is a part, for writeModelPart.
    std::optional<BinSet> bins{};
    int threads = 0;  ///< maximum; 0: one per processor
};

/// Above this number of scenes, exact training prints a notice about inducing rows. docs/speed.md has their time and
/// error.
inline constexpr int kManyRows = 3000;

/// The processes learnt for every bin, in this order, two kinds in parallel.
enum class TrainingKind : std::uint8_t {
    Paf,               ///< p(hᵢ | h_{J∖i}, s), s with currents and forces
    Pa,                ///< p(hᵢ | h_{J∖i}, s), s without currents and forces
    SurfaceCovered,    ///< the bin's surface given s, under the robot
    SurfaceOpen,       ///< the bin's surface given s, elsewhere
    ClearanceCovered,  ///< p(yᵢ | y_{J∖i}, s) over clearances
    ClearanceOpen,
    SideCovered,  ///< the surface of one of two sides, under the robot; with TrainingPlan::tracks
    SideOpen,
};
/// Kinds of every training.
inline constexpr std::array kTrainingKinds{TrainingKind::Paf,
                                           TrainingKind::Pa,
                                           TrainingKind::SurfaceCovered,
                                           TrainingKind::SurfaceOpen,
                                           TrainingKind::ClearanceCovered,
                                           TrainingKind::ClearanceOpen};

/// Returns the name of two kinds in progress texts: "Gaussian process", "surface", "clearance", "side".
std::string_view stageOf(TrainingKind kind);

enum class TrainingEvent : std::uint8_t {
    Begun,
    Done,
    Skipped,  ///< too few scenes in that regime; the model omits it
};

/// Start or end of one bin of one kind.
struct TrainingStep {
    TrainingKind kind = TrainingKind::Paf;
    int bin = 0;
    TrainingEvent event = TrainingEvent::Begun;
    /// log p(y | X) of the last rows of the hyperparameter search, if kept.
    std::optional<double> logLikelihood;
    int stageTotal = 0;  ///< bins × kinds of this stage
    double share = 0.0;  ///< 0 … 1, estimated share of the work of all stages
};

/// Callbacks of a training; each may be empty.
struct TrainingWatch {
    std::function<bool()> cancelled;                    ///< any thread, every few milliseconds
    std::function<void(const TrainingStep&)> progress;  ///< one thread at a time
    std::function<void(const Message&)> notice;         ///< a sentence about the file
    /// The weight of generated scenes that was chosen, of two tracks and of one plane.
    std::function<void(const CardMix&)> mix{}, planeMix{};
};

/// Trains a model; it is complete unless the plan names bins. Plans that differ only in threads give the same model on
/// the same machine. Bins exclude tracks and generated scenes: std::invalid_argument. Errors name the file and, if
/// known, the line. Throws Cancelled (core/infer/sampling/watch.h) once watch.cancelled() returns true.
Result<ModelData> trainModel(const TrainingPlan& plan, const TrainingWatch& watch = {});

}  // namespace terratact
