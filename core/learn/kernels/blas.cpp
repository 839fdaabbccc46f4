#include "core/learn/kernels/blas.h"

#include <cstddef>
#include <stdexcept>
#include <string>

#include "core/base/memory_limit.h"

namespace terratact {
namespace {

// buffer of OpenBLAS on every processor it supports
constexpr std::size_t kBuffer = std::size_t{128} << 20U;
constexpr std::size_t kBeside = std::size_t{4} << 20U;  // other allocations meanwhile

// One per process, like OpenBLAS's buffers.
std::mutex turns;
bool hasBuffer = false;

// Ensures the buffer. OpenBLAS keeps it once it has it.
void allocateBuffer()
{
    if (hasBuffer) return;
    if (const std::string missing = memoryMissing("OpenBLAS", kBuffer + kBeside); !missing.empty())
        throw std::runtime_error(missing);
    const double one = 1.0;
    double product = 0.0;
    cblas_dsyrk(CblasColMajor, CblasUpper, CblasNoTrans, 1, 1, 1.0, &one, 1, 0.0, &product, 1);
    hasBuffer = true;
}

}  // namespace

BlasTurn::BlasTurn()
{
    static const bool limited = memoryIsLimited();
    if (!limited) return;
    lock_ = std::unique_lock(turns);
    allocateBuffer();
}

}  // namespace terratact
