#pragma once

#include <functional>

namespace terratact {

/// Calls work(0) … work(count − 1), each once, in any order or side by side: how core is lent threads.
using ForEach = std::function<void(int count, const std::function<void(int)>& work)>;

}  // namespace terratact
