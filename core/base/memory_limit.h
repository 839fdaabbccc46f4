#pragma once

#include <cstddef>
#include <exception>
#include <string>

namespace terratact {

/// Returns true if the system may refuse memory to this process. One cause is a limit of its address
/// space (ulimit -v) or data (ulimit -d). The other is a kernel without overcommit
/// (vm.overcommit_memory = 2). It allocates nothing and may be called before main(). It returns
/// false where the system offers no such query.
bool memoryIsLimited();

/// Returns a sentence for the user. It names the need of `forWhat`, the use and the limit of this
/// process, the shortage, and what to do. bytes: what is needed; 0: unknown.
std::string outOfMemory(const std::string& forWhat, std::size_t bytes);

/// Tries to allocate `bytes`; returns an empty text on success, else outOfMemory().
std::string memoryMissing(const std::string& forWhat, std::size_t bytes);

/// Returns the text for an exception that ends a program. std::bad_alloc gives outOfMemory(). So
/// does a thread that did not start where memory is limited. Any other exception gives its own
/// text.
std::string describeFailure(const std::exception& error);

}  // namespace terratact
