#pragma once

#include <string>

#include "core/learn/model/model_part.h"

namespace terratact::model_file {

/// Refusal of a model: a sentence without the file's name. model_file.cpp catches it.
struct Refused {
    std::string cause;
};

/// Throws Refused{cause} unless the condition holds.
void require(bool holds, const std::string& cause);

/// Throws Refused unless the model can predict: sizes, finite numbers, and ranges as in readModel.
/// With a portion, the model must hold that portion and nothing else.
void requireModel(const ModelData& model, const Portion* portion = nullptr);

}  // namespace terratact::model_file
