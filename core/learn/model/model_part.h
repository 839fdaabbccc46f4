#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/learn/data/bin_set.h"
#include "core/learn/model/model.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Which share of a training a run has done, and of which training.
struct Portion {
    BinSet bins;
    std::string robotHash;  ///< SHA-256 of the robot file, hex
    /// The command that does all bins in one run, around the name of the model it writes.
    std::string commandBeforeOut, commandAfterOut;
};

/// What one of several runs of a training has made: the processes of some bins.
struct ModelPart {
    /// All rows and standardisations; hyper-parameters, surfaces and residuals of the portion's bins only,
    /// and of ClearanceData neither novelty scale nor contacts, which need all bins.  command: of this run.
    ModelData model;
    Portion portion;
};

/// A part and the file it comes from, for messages.
struct NamedModelPart {
    std::string path;
    ModelPart part;
};

/// Writes a *.ttp: the tables of a *.ttm (core/learn/model/model_file.h), application_id 0x54545031, with the rows of its
/// own bins alone.  Throws std::invalid_argument for a part that readModelPart would refuse.
Status writeModelPart(const std::string& path, const ModelPart& part);

/// Validates as readModel does.
Result<ModelPart> readModelPart(const std::string& path);

/// The model that one run over all bins would have written to `out`, up to and including its content hash.
/// Errors name a file and what was expected: no part; a part of another training (other rows, seed,
/// command or robot); a bin that two parts hold, or none.
/// robot: the one of the training, robotHash of its file.
Result<ModelData> mergeModelParts(std::span<const NamedModelPart> parts, const RobotModel& robot,
                                  const std::string& robotHash, const std::string& out);

}  // namespace terratact
