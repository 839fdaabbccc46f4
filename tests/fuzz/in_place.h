#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace terratact::fuzz {

/// LLVMFuzzerCustomMutator for formats whose header has the file's length. It starts from a real file and changes a few
/// neighbouring bytes at a time, never the size. It does nothing if `most` is too small for the file.
inline std::size_t mutateInPlace(const std::string& real, std::uint8_t* data, std::size_t size,
                                 std::size_t most, unsigned seed)
{
    if (size != real.size() && real.size() <= most) {
        std::copy(real.begin(), real.end(), data);
        return real.size();
    }
    if (size == 0) return LLVMFuzzerMutate(data, size, most);
    std::minstd_rand rng(seed);
    constexpr std::size_t kMaxChanged = 64;  // bytes
    const std::size_t at = std::uniform_int_distribution<std::size_t>(0, size - 1)(rng);
    const std::size_t length = std::min(kMaxChanged, size - at);
    LLVMFuzzerMutate(data + at, std::uniform_int_distribution<std::size_t>(1, length)(rng), length);
    return size;
}

}  // namespace terratact::fuzz
