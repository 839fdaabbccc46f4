#pragma once

#include <cblas.h>
#include <lapacke.h>

#include <mutex>

namespace terratact {

/// Serialises OpenBLAS where memory is limited (core/base/memory_limit.h). One thread at a time may
/// call it. The first call ensures that OpenBLAS gets its buffer. OpenBLAS allocates 128 MB for each
/// calling thread, and retries forever if that fails. Without a memory limit this does nothing.
class BlasTurn {
public:
    /// Throws std::runtime_error with outOfMemory() if the buffer cannot be allocated.
    BlasTurn();

private:
    std::unique_lock<std::mutex> lock_;
};

/// Calls a function of OpenBLAS. Core calls OpenBLAS only through this function.
template <class Function, class... Arguments>
auto blas(Function function, Arguments... arguments)
{
    const BlasTurn turn;
    return function(arguments...);
}

}  // namespace terratact
