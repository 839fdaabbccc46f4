#pragma once

#include <cblas.h>
#include <lapacke.h>

#include <mutex>

namespace terratact {

/// Serialises OpenBLAS where memory is limited (core/base/memory_limit.h). One thread at a time may
/// call it. The first call ensures that OpenBLAS gets its buffer. OpenBLAS asks for 128 MB for each
/// calling thread, and retries for ever if that is refused. Without a memory limit this does
/// nothing.
class BlasTurn {
public:
    /// Throws std::runtime_error with outOfMemory() if there is no room for the buffer.
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
