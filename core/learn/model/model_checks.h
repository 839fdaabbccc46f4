#pragma once

#include <string>

#include "core/learn/model/model_part.h"

namespace terratact::model_file {

/// Why a model is refused: a sentence that lacks the file's name.  Does not leave model_file.cpp.
struct Refused {
    std::string cause;
};

/// Throws Refused{cause} unless it holds.
void require(bool holds, const std::string& cause);

/// Throws Refused unless the model can predict: sizes, finite numbers, ranges as readModel says; with a
/// portion: unless it holds that portion and nothing else.
void requireModel(const ModelData& model, const Portion* portion = nullptr);

}  // namespace terratact::model_file
