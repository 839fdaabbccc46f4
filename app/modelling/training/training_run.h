#pragma once

#include <cstdint>

#include "app/modelling/training/model_training.h"
#include "core/learn/model/model.h"

namespace terratact {

/// What one run of a training learns.
struct TrainingScope {
    enum class Parts : std::uint8_t {
        All,       ///< one plane, and both sides if the model has their rows
        Sides,     ///< both sides alone: the model has its part of one plane already
        Surfaces,  ///< the surfaces of one plane alone, which method local needs
    };
    Parts parts = Parts::All;
    int surfaceRows = 800;  ///< rows on which hyperparameters of surfaces are searched
};

/// Learns the processes of a model whose rows are set; of plan.bins alone, if it names some. The jobs of a stage run in
/// parallel, the stages one after another. Throws as trainModel().
void runTraining(ModelData& model, const TrainingPlan& plan, const TrainingWatch& watch,
                 const TrainingScope& scope = {});

}  // namespace terratact
