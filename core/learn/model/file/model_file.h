#pragma once

#include <string>

#include "core/base/result.h"
#include "core/learn/model/model.h"

namespace terratact {

/// A model that was read, with the hash of its content.
struct StoredModel {
    ModelData data;
    std::string contentHash;  ///< SHA-256, hex
};

/// Returns the SHA-256 (hex) of everything that decides predictions, and of the training command,
/// in a fixed order. Throws std::invalid_argument for a model that readModel would refuse.
std::string contentHash(const ModelData& model);

/// Writes a *.ttm file: one SQLite file (application_id 0x54544D31, user_version 3, or 4 with two
/// tracks). It holds feature order, units, standardisation, hyperparameters, training rows, the
/// training command and the content's hash. The same model gives the same bytes. The file is written under a temporary
/// name and then renamed. Throws std::invalid_argument for a model that readModel would refuse.
Status writeModel(const std::string& path, const ModelData& model);

/// Opens a model read-only and validates it: application_id, user_version, integrity, schema,
/// feature order and units. It needs 1 … 20 000 training rows of finite numbers in the ranges of
/// the scenes file. ℓ, σ_f and sd lie within 1e-9 … 1e9, and σ_n is at least 0. The content's hash
/// must match. Errors are one sentence that names the file and the cause.
Result<StoredModel> readModel(const std::string& path);

}  // namespace terratact
