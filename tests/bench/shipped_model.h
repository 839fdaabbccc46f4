#pragma once

#include <stdexcept>

#include "core/learn/model/file/model_file.h"

namespace terratact {

/// Returns the shipped model; throws std::runtime_error if it cannot be read.
inline const ModelData& shippedModel()
{
    static const ModelData model = [] {
        auto stored = readModel(TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
        if (!stored) throw std::runtime_error(stored.error().text);
        return stored->data;
    }();
    return model;
}

}  // namespace terratact
