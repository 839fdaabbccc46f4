#include "core/wire/absolem_text.h"

#include <fmt/format.h>

#include <span>
#include <string_view>

namespace terratact {
namespace {

struct Bit {
    unsigned position;
    std::string_view phrase;
};

// Returns phrases for the bits that are set. Bits without a name are collected as one number.
std::vector<std::string> phrasesOf(std::uint32_t bits, std::span<const Bit> names,
                                   std::uint32_t ignored = 0)
{
    std::vector<std::string> phrases;
    std::uint32_t unnamed = bits & ~ignored;
    for (const Bit& bit : names) {
        const std::uint32_t mask = std::uint32_t{1} << bit.position;
        if ((bits & mask) != 0) phrases.emplace_back(bit.phrase);
        unnamed &= ~mask;
    }
    if (unnamed != 0) phrases.push_back(fmt::format("other bits {:#x}", unnamed));
    return phrases;
}

std::uint32_t field(std::uint32_t bits, unsigned first, unsigned count)
{
    return (bits >> first) & ((1U << count) - 1U);
}

std::string problemPhrase(std::uint32_t status)
{
    switch (status) {
    case 1: return "under-voltage";
    case 2: return "over-voltage";
    case 5: return "short circuit";
    case 6: return "overheated";
    default: return fmt::format("drive status {}", status);
    }
}

constexpr Bit kStatusWord[]{{0, "ready to switch on"},
                            {1, "switched on"},
                            {2, "operation enabled"},
                            {3, "fault"},
                            {4, "voltage enabled"},
                            {5, "no quick stop"},
                            {6, "switch on disabled"},
                            {7, "warning"},
                            {9, "remote"},
                            {10, "target reached"},
                            {11, "limit active"}};
constexpr Bit kStatusRegister[]{{4, "motor on"},
                                {5, "external reference"},
                                {6, "motor failure"},
                                {10, "gain scheduling"},
                                {11, "homing"},
                                {12, "program running"},
                                {13, "current limit"},
                                {27, "processor exception"},
                                {28, "stopped by a limit"},
                                {29, "error in the drive's program"}};
constexpr Bit kMotorFault[]{{0, "analogue feedback not ready"},
                            {2, "encoder and Hall sensors do not match"},
                            {3, "peak current exceeded"},
                            {4, "inhibited"},
                            {6, "two Hall sensors changed at once"},
                            {7, "speed error over its limit"},
                            {8, "position error over its limit"}};

// Bit fields: error and its reason, unit mode, motion, recorder, Hall sensors.
constexpr std::uint32_t kFields =
    0x0000'000F | 0x0000'0380 | 0x0000'C000 | 0x0003'0000 | 0x0700'0000;

}  // namespace

std::vector<std::string> statusWordPhrases(std::uint16_t word)
{
    return phrasesOf(word, kStatusWord);
}

std::vector<std::string> statusRegisterPhrases(std::uint32_t bits)
{
    std::vector<std::string> phrases;
    if ((bits & 1U) != 0) phrases.push_back(problemPhrase(field(bits, 1, 3)));
    for (std::string& phrase : phrasesOf(bits, kStatusRegister, kFields))
        phrases.push_back(std::move(phrase));
    if (field(bits, 14, 2) == 2) phrases.emplace_back("moving");
    if (const std::uint32_t mode = field(bits, 7, 3); mode != 0)
        phrases.push_back(unitModeWord(mode) + " mode");
    return phrases;
}

std::vector<std::string> motorFaultPhrases(std::uint32_t bits)
{
    return phrasesOf(bits, kMotorFault);
}

std::string unitModeWord(std::uint32_t mode)
{
    switch (mode) {
    case 1: return "torque";
    case 2: return "velocity";
    case 5: return "position";
    default: return fmt::format("unit {}", mode);
    }
}

}  // namespace terratact
