#pragma once

#include <functional>

namespace terratact {

/// Calls work(0) … work(count − 1), each once, in any order or in parallel. Callers lend threads to
/// core this way.
using ForEach = std::function<void(int count, const std::function<void(int)>& work)>;

}  // namespace terratact
