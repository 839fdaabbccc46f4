#include "core/store/sha256.h"

#include <sodium/crypto_hash_sha256.h>
#include <sodium/utils.h>

#include <array>
#include <filesystem>
#include <system_error>

#include "core/store/file_read.h"

namespace terratact {

std::string sha256Hex(std::string_view bytes)
{
    std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
    crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(bytes.data()),
                       bytes.size());
    return hexOf({reinterpret_cast<const char*>(hash.data()), hash.size()});
}

std::string hexOf(std::string_view bytes)
{
    std::string hex(2 * bytes.size() + 1, '\0');
    sodium_bin2hex(hex.data(), hex.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                   bytes.size());
    hex.pop_back();
    return hex;
}

struct Sha256::State {
    State() { crypto_hash_sha256_init(&value); }
    crypto_hash_sha256_state value{};
};

Sha256::Sha256() : state_(std::make_unique<State>()) {}
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes)
{
    crypto_hash_sha256_update(&state_->value, reinterpret_cast<const unsigned char*>(bytes.data()),
                              bytes.size());
}

std::string Sha256::finish()
{
    std::string hash(kBytes, '\0');
    crypto_hash_sha256_final(&state_->value, reinterpret_cast<unsigned char*>(hash.data()));
    crypto_hash_sha256_init(&state_->value);
    return hash;
}

Result<std::string> sha256OfFile(const std::string& path)
{
    std::error_code unknown;
    const auto there = std::filesystem::status(path, unknown);
    if (std::filesystem::is_fifo(there) || std::filesystem::is_character_file(there))
        return fileError(path, TR_NOOP("core", "is a pipe or a device, which is read only once, "
                                               "and this is read twice: save it as a file first"));
    constexpr std::size_t kMaxHashed = std::size_t{1} << 30U;
    const auto bytes = readFile(path, kMaxHashed);
    if (!bytes) return bytes.error();
    return sha256Hex(*bytes);
}

}  // namespace terratact
