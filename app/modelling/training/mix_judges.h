#pragma once

#include <vector>

#include "app/modelling/training/model_training.h"
#include "core/learn/data/scene.h"
#include "core/learn/data/two_track_scene.h"
#include "core/learn/model/model.h"

namespace terratact {

// Judges of mixes (scene_mixing.h). Each trains a small model by method local: its hyperparameters are searched on at
// most 300 rows. It returns the |errors| [m] on the judged scenes, bins −0.3 … 0.5 m. Throw Cancelled.

/// Judges models of one plane.
class PlaneJudge {
public:
    PlaneJudge(const TrainingPlan& plan, const TrainingWatch& watch);
    std::vector<double> operator()(const std::vector<Scene>& learnt,
                                   const std::vector<Scene>& judged);

private:
    TrainingPlan plan_;
    TrainingWatch watch_;
};

/// Judges models of two tracks. plane: a model with its part of one plane.
class SideJudge {
public:
    SideJudge(const ModelData& plane, const TrainingPlan& plan, const TrainingWatch& watch);
    std::vector<double> operator()(const std::vector<TwoTrackScene>& learnt,
                                   const std::vector<TwoTrackScene>& judged);

private:
    TrainingPlan plan_;
    TrainingWatch watch_;
    ModelData model_;
};

}  // namespace terratact
