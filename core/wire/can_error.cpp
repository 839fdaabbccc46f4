#include "core/wire/can_error.h"

#include <array>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace terratact {
namespace {

struct Word {
    std::uint32_t value;
    std::string_view text;
};

// Error classes: bits of the identifier.
constexpr std::uint32_t kLostArbitration = 0x002, kController = 0x004, kProtocol = 0x008,
                        kTransceiver = 0x010, kBusOff = 0x040, kRestarted = 0x100,
                        kCounters = 0x200;
constexpr std::array<Word, 6> kPlainClasses{{{0x001, "transmission timed out"},
                                             {0x020, "nobody acknowledged"},
                                             {kBusOff, "bus-off"},
                                             {0x080, "bus error"},
                                             {kRestarted, "controller restarted"},
                                             {kCounters, ""}}};
constexpr std::uint32_t kKnownClasses = 0x3ff;

// Details of a class: bits of a byte, or the value of that byte.
constexpr std::uint8_t kReceivePassive = 0x10, kTransmitPassive = 0x20, kWarnings = 0x0c,
                       kActive = 0x40;
constexpr std::array<Word, 7> kControllerBits{{{0x01, "receive buffer overflowed"},
                                               {0x02, "transmit buffer overflowed"},
                                               {0x04, "many receive errors"},
                                               {0x08, "many transmit errors"},
                                               {kReceivePassive, "error passive in receiving"},
                                               {kTransmitPassive, "error passive in transmitting"},
                                               {kActive, "error active again"}}};
constexpr std::array<Word, 8> kProtocolBits{{{0x01, "single bit"},
                                             {0x02, "frame format"},
                                             {0x04, "bit stuffing"},
                                             {0x08, "dominant bit not sent"},
                                             {0x10, "recessive bit not sent"},
                                             {0x20, "bus overload"},
                                             {0x40, "active error announced"},
                                             {0x80, "in transmitting"}}};
constexpr std::array<Word, 20> kPlaces{{{0x03, "start of frame"},
                                        {0x02, "identifier bits 28 to 21"},
                                        {0x06, "identifier bits 20 to 18"},
                                        {0x04, "substitute RTR"},
                                        {0x05, "identifier extension"},
                                        {0x07, "identifier bits 17 to 13"},
                                        {0x0f, "identifier bits 12 to 5"},
                                        {0x0e, "identifier bits 4 to 0"},
                                        {0x0c, "RTR"},
                                        {0x0d, "reserved bit 1"},
                                        {0x09, "reserved bit 0"},
                                        {0x0b, "data length"},
                                        {0x0a, "data"},
                                        {0x08, "checksum"},
                                        {0x18, "checksum delimiter"},
                                        {0x19, "acknowledge slot"},
                                        {0x1b, "acknowledge delimiter"},
                                        {0x1a, "end of frame"},
                                        {0x12, "intermission"},
                                        {0x00, ""}}};
constexpr std::array<Word, 9> kWires{{{0x04, "CAN-H has no wire"},
                                      {0x05, "CAN-H shorted to the battery"},
                                      {0x06, "CAN-H shorted to the supply"},
                                      {0x07, "CAN-H shorted to ground"},
                                      {0x40, "CAN-L has no wire"},
                                      {0x50, "CAN-L shorted to the battery"},
                                      {0x60, "CAN-L shorted to the supply"},
                                      {0x70, "CAN-L shorted to ground"},
                                      {0x80, "CAN-L shorted to CAN-H"}}};

void requireError(const CanFrame& frame)
{
    if (!frame.error) throw std::invalid_argument("not an error frame");
}

std::uint8_t byteOf(const CanFrame& frame, std::size_t at)
{
    return at < frame.length && at < frame.data.size() ? frame.data[at] : std::uint8_t{0};
}

/// Returns the words of all bits that are set; "unspecified" for none.
std::string ofBits(std::uint32_t bits, std::span<const Word> words)
{
    std::vector<std::string_view> set;
    for (const Word& word : words)
        if (bits & word.value) set.push_back(word.text);
    return set.empty() ? "unspecified" : fmt::format("{}", fmt::join(set, ", "));
}

std::string ofNumber(std::uint32_t number, std::span<const Word> words)
{
    for (const Word& word : words)
        if (number == word.value) return std::string(word.text);
    return fmt::format("unknown place 0x{:02x}", number);
}

std::string ofWires(std::uint8_t status)
{
    if (status == 0) return "unspecified";
    std::vector<std::string> words;
    for (const std::uint32_t half : {status & 0x0fu, status & 0xf0u}) {
        if (half == 0) continue;
        std::string word = fmt::format("unknown state 0x{:02x}", half);
        for (const Word& wire : kWires)
            if (wire.value == half) word = wire.text;
        words.push_back(std::move(word));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string ofProtocol(const CanFrame& frame)
{
    std::string words = ofBits(byteOf(frame, 2), kProtocolBits);
    if (const std::string place = ofNumber(byteOf(frame, 3), kPlaces); !place.empty())
        words += " at " + place;
    return words;
}

}  // namespace

std::optional<ControllerState> controllerState(const CanFrame& frame)
{
    requireError(frame);
    const std::uint8_t controller = frame.id & kController ? byteOf(frame, 1) : std::uint8_t{0};
    if (frame.id & kBusOff) return ControllerState::BusOff;
    if (controller & (kReceivePassive | kTransmitPassive)) return ControllerState::Passive;
    if (controller & kWarnings) return ControllerState::Warning;
    if ((frame.id & kRestarted) || (controller & kActive)) return ControllerState::Active;
    return std::nullopt;
}

std::string describeError(const CanFrame& frame)
{
    requireError(frame);
    std::vector<std::string> parts;
    for (const Word& word : kPlainClasses)
        if ((frame.id & word.value) && !word.text.empty()) parts.emplace_back(word.text);
    if (frame.id & kLostArbitration) {
        const int bit = byteOf(frame, 0);
        parts.push_back(bit == 0 ? "arbitration lost"
                                 : fmt::format("arbitration lost in bit {}", bit));
    }
    if (frame.id & kController)
        parts.push_back("controller: " + ofBits(byteOf(frame, 1), kControllerBits));
    if (frame.id & kProtocol) parts.push_back("protocol: " + ofProtocol(frame));
    if (frame.id & kTransceiver) parts.push_back("transceiver: " + ofWires(byteOf(frame, 4)));
    if (frame.id & kCounters)
        parts.push_back(
            fmt::format("{} transmit and {} receive errors", byteOf(frame, 6), byteOf(frame, 7)));
    if (const std::uint32_t unknown = frame.id & ~kKnownClasses)
        parts.push_back(fmt::format("unknown class 0x{:x}", unknown));
    return parts.empty() ? "unspecified error" : fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace terratact
