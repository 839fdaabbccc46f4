#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/learn/data/bin_set.h"
#include "core/learn/model/model.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Share of a training that one run has done, and identification of that training.
struct Portion {
    BinSet bins;
    std::string robotHash;  ///< SHA-256 of the robot file, hex
    /// Command that trains all bins in one run, split around the name of the model that it writes.
    std::string commandBeforeOut, commandAfterOut;
};

/// Result of one of several runs of a training: the processes of some bins.
struct ModelPart {
    /// All rows and standardisations, but hyperparameters, surfaces and residuals of the portion's
    /// bins only. ClearanceData lacks novelty scale and contacts, which need all bins. command: of
    /// this run.
    ModelData model;
    Portion portion;
};

/// A part and its file, for messages.
struct NamedModelPart {
    std::string path;
    ModelPart part;
};

/// Writes a *.ttp file: the tables of a *.ttm (core/learn/model/file/model_file.h) with application_id
/// 0x54545031 and the rows of its bins only. Throws std::invalid_argument for a part that
/// readModelPart would refuse.
Status writeModelPart(const std::string& path, const ModelPart& part);

/// Reads a part, and validates it as readModel does.
Result<ModelPart> readModelPart(const std::string& path);

/// Returns the model that one run over all bins would have written to `out`, with the same content
/// hash. Errors name a file and what was expected. Causes: no part; a part of another training
/// (other rows, seed, command or robot); a bin in two parts, or in none. robot: of the training;
/// robotHash: of its file.
Result<ModelData> mergeModelParts(std::span<const NamedModelPart> parts, const RobotModel& robot,
                                  const std::string& robotHash, const std::string& out);

}  // namespace terratact
