#include "core/learn/sha256.h"

#include <sodium/crypto_hash_sha256.h>
#include <sodium/utils.h>

#include <array>

#include "core/file_read.h"

namespace terratact {

std::string sha256Hex(std::string_view bytes)
{
    std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
    crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(bytes.data()),
                       bytes.size());
    std::array<char, 2 * crypto_hash_sha256_BYTES + 1> hex{};
    sodium_bin2hex(hex.data(), hex.size(), hash.data(), hash.size());
    return hex.data();
}

Result<std::string> sha256OfFile(const std::string& path)
{
    constexpr std::size_t kMostHashed = std::size_t{1} << 30U;
    const auto bytes = readFile(path, kMostHashed);
    if (!bytes) return bytes.error();
    return sha256Hex(*bytes);
}

}  // namespace terratact
