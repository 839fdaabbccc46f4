#include "core/wire/e2e.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

constexpr std::uint32_t kWindowBits = (1U << E2eReceiver::kWindow) - 1U;

bool isSound(FrameCheck check)
{
    return check == FrameCheck::Ok || check == FrameCheck::SomeLost;
}

std::uint8_t low(std::uint16_t word)
{
    return static_cast<std::uint8_t>(word & 0xFFU);
}

std::uint8_t high(std::uint16_t word)
{
    return static_cast<std::uint8_t>(word >> 8U);
}

std::uint16_t checksum(std::span<const std::uint8_t> bytes, std::uint16_t dataId)
{
    const std::uint8_t id[]{low(dataId), high(dataId)};
    return crc16(id, crc16(bytes.subspan(2)));
}

void requireFinite(double now)
{
    if (!std::isfinite(now)) throw std::invalid_argument("E2eReceiver: the time must be finite");
}

}  // namespace

std::uint16_t crc16(std::span<const std::uint8_t> bytes, std::uint16_t start)
{
    std::uint32_t crc = start;
    for (const std::uint8_t byte : bytes) {
        crc ^= static_cast<std::uint32_t>(byte) << 8U;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 0x8000U) != 0 ? (crc << 1U) ^ 0x1021U : crc << 1U;
    }
    return static_cast<std::uint16_t>(crc & 0xFFFFU);
}

void protect(std::span<std::uint8_t> bytes, std::uint8_t counter, std::uint16_t dataId)
{
    if (bytes.size() < kE2eHeader)
        throw std::invalid_argument("protect: fewer than three bytes hold no header");
    bytes[2] = counter;
    const std::uint16_t crc = checksum(bytes, dataId);
    bytes[0] = low(crc);
    bytes[1] = high(crc);
}

bool isIntact(std::span<const std::uint8_t> bytes, std::uint16_t dataId)
{
    if (bytes.size() < kE2eHeader) return false;
    const std::uint16_t crc = checksum(bytes, dataId);
    return bytes[0] == low(crc) && bytes[1] == high(crc);
}

E2eReceiver::E2eReceiver(std::uint16_t dataId, Limits limits) : dataId_(dataId), limits_(limits)
{
    if (!(limits.stale > 0.0 && limits.lost >= limits.stale && std::isfinite(limits.lost)))
        throw std::invalid_argument("E2eReceiver: the limits must be 0 < stale <= lost");
}

FrameCheck E2eReceiver::receive(std::span<const std::uint8_t> bytes, double now)
{
    const bool anew = state(now) == LinkState::Lost;
    if (anew) {
        seen_ = 0;  // history_ then holds no old frame when it counts again
        wasGood_ = good_ = false;
    }
    const FrameCheck check = judge(bytes, anew);
    remember(check);
    if (isSound(check)) lastSound_ = now;
    return check;
}

FrameCheck E2eReceiver::judge(std::span<const std::uint8_t> bytes, bool anew)
{
    if (!isIntact(bytes, dataId_)) return FrameCheck::WrongCrc;
    const std::uint8_t counter = bytes[2];
    const std::optional<std::uint8_t> before = counter_;
    counter_ = counter;
    if (!before) return FrameCheck::Ok;
    const int delta = (counter - *before) & 0xFF;
    if (delta == 0) return FrameCheck::Repeated;
    if (anew) return FrameCheck::Ok;
    if (delta > kMaxDelta) return FrameCheck::WrongSequence;
    return delta == 1 ? FrameCheck::Ok : FrameCheck::SomeLost;
}

void E2eReceiver::remember(FrameCheck check)
{
    history_ = ((history_ << 1U) | (isSound(check) ? 0U : 1U)) & kWindowBits;
    seen_ = std::min(seen_ + 1, kWindow);
    if (errors() >= kErrors) good_ = false;
    if (seen_ == kWindow && errors() == 0) wasGood_ = good_ = true;
}

int E2eReceiver::errors() const
{
    return std::popcount(history_);
}

std::optional<double> E2eReceiver::age(double now) const
{
    requireFinite(now);
    return lastSound_ ? std::optional(now - *lastSound_) : std::nullopt;
}

LinkState E2eReceiver::state(double now) const
{
    const std::optional<double> since = age(now);
    if (!since) return seen_ == 0 ? LinkState::Unknown : LinkState::Starting;
    if (*since < 0.0 || *since > limits_.lost) return LinkState::Lost;
    if (!wasGood_) return LinkState::Starting;
    if (!good_) return LinkState::Bad;
    return *since > limits_.stale ? LinkState::Stale : LinkState::Good;
}

}  // namespace terratact
