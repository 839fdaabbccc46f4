#pragma once

#include <concepts>

#include "core/base/message.h"
#include "core/learn/model/file/model_part.h"

namespace terratact::model_file {

/// Refusal of a model: a sentence without the file's name. model_file.cpp catches it.
class Refused : public Failure {
public:
    using Failure::Failure;
};

/// Throws Refused{cause} unless the condition holds.
inline void require(bool holds, SourceText cause)
{
    if (!holds) throw Refused{cause};
}
template <std::invocable Cause>
void require(bool holds, const Cause& cause)
{
    if (!holds) throw Refused{cause()};
}

/// Throws Refused unless the model can predict: sizes, finite numbers, and ranges as in readModel.
/// With a portion, the model must hold that portion and nothing else.
void requireModel(const ModelData& model, const Portion* portion = nullptr);

}  // namespace terratact::model_file
