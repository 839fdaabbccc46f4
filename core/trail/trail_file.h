#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "core/trail/trail_model.h"

namespace terratact {

/// Networks that were read, with the hash of their content.
struct StoredTrail {
    TrailData data;
    std::string contentHash;  ///< SHA-256, hex
};

/// Steps in which a file holds TrailErrors, in their units. Training rounds to them, so that a file
/// of integers keeps every bit.
inline constexpr double kTrailErrorStep = 1e-3;

/// Returns an error in these steps, rounded, at most 32 000.
std::int16_t errorSteps(float error);
/// Returns the error of a number of steps.
float errorOfSteps(std::int16_t steps);

/// Largest number of scenes of errors of one kind of networks.
inline constexpr Eigen::Index kMaxTrailErrors = 12'000;

/// Writes a *.ttn file: one SQLite file (application_id 0x54544E31, user_version 4). It holds the
/// inputs' mean and sd, the scales of the bins, the training command and the content's hash. Layers
/// are 32-bit floats, little endian, column by column. Errors are 16-bit integers in
/// kTrailErrorStep. Marks of the training drives (core/learn/data/drive_copies.h) are 32-bit
/// integers. The same data give the same bytes. The file is written under a temporary name and then
/// renamed. Throws std::invalid_argument for data that readTrail() would refuse.
Status writeTrail(const std::string& path, const TrailData& data);

/// Opens the file read-only and validates it: application_id, user_version 4 (or 3, without marks of
/// drives) and schema. It has at most 16 networks of at most 8 layers. Behind them is the network of
/// the errors' size. A layer has at most 499 numbers each way. Numbers must be finite, and the content's hash must
/// match. Errors are one sentence that names the file and the cause.
Result<StoredTrail> readTrail(const std::string& path);

}  // namespace terratact
