#pragma once

#include <cblas.h>
#include <lapacke.h>

#include <mutex>

namespace terratact {

/// Where memory is limited (core/base/memory_limit.h), one thread at a time may call OpenBLAS, and the first one makes
/// sure that OpenBLAS gets its buffer.  OpenBLAS asks for one of 128 MB for each thread that calls it, and where it
/// is refused asks again for ever.  Elsewhere this does nothing.
class BlasTurn {
public:
    /// Throws std::runtime_error with outOfMemory() where there is no room for the buffer.
    BlasTurn();

private:
    std::unique_lock<std::mutex> lock_;
};

/// Calls a function of OpenBLAS; core calls none in any other way.
template <class Function, class... Arguments>
auto blas(Function function, Arguments... arguments)
{
    const BlasTurn turn;
    return function(arguments...);
}

}  // namespace terratact
