#pragma once

#include <cstddef>
#include <exception>
#include <string>

namespace terratact {

/// Whether the system may refuse this process memory: a limit of its address space (ulimit -v) or of its data
/// (ulimit -d), or a kernel that promises no more than it has (vm.overcommit_memory = 2).  Allocates nothing, and may
/// be called before main().  False where the system is not asked.
bool memoryIsLimited();

/// A sentence for the user: `forWhat` needs `bytes`, what this process uses, its limit, how much is missing, and
/// what to do.  bytes: 0 where nobody knows.
std::string outOfMemory(const std::string& forWhat, std::size_t bytes);

/// Empty where as much can be allocated now, which is tried; else outOfMemory().
std::string memoryMissing(const std::string& forWhat, std::size_t bytes);

/// What to say of an exception that ends a program: outOfMemory() for std::bad_alloc, and for a thread that did not
/// start where memory is limited; else what it says itself.
std::string describeFailure(const std::exception& error);

}  // namespace terratact
