#pragma once

#include <memory>
#include <stdexcept>
#include <utility>

#include "app/modelling/scene_estimates.h"
#include "core/base/result.h"

namespace terratact {

/// Returns the value; throws std::runtime_error with the text of the error.
template <class T>
T valueOf(Result<T> result)
{
    if (!result) throw std::runtime_error(result.error().text);
    return *std::move(result);
}

/// Opens the shipped robot, model and networks; throws std::runtime_error if one cannot be read.
inline std::unique_ptr<EstimatorBundle> shippedBundle()
{
    return valueOf(openEstimatorBundle(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml",
                                       TERRATACT_SOURCE_DIR "/resources/models/default.ttm",
                                       TERRATACT_SOURCE_DIR "/resources/models/default.ttn"));
}

}  // namespace terratact
