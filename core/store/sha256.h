#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// Returns the SHA-256 of the bytes as 64 lower-case hexadecimal digits (FIPS 180-4).
std::string sha256Hex(std::string_view bytes);

/// Returns the SHA-256 of a file's bytes, at most 1 GiB. Errors as readFile.
Result<std::string> sha256OfFile(const std::string& path);

/// SHA-256 of bytes that arrive in pieces.
class Sha256 {
public:
    static constexpr std::size_t kBytes = 32;

    Sha256();
    Sha256(Sha256&&) noexcept;
    Sha256& operator=(Sha256&&) noexcept;
    ~Sha256();

    void add(std::string_view bytes);
    /// Returns the 32 bytes of the hash of everything since the last finish(), and starts a new hash.
    std::string finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Returns the bytes in lower-case hexadecimal digits.
std::string hexOf(std::string_view bytes);

}  // namespace terratact
