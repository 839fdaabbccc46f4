#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace terratact {

// Phrases for the bits that an Absolem's drives report, one phrase for each bit with a meaning. A
// bit without a known meaning is named by its value.

/// Returns phrases for the status word that a drive sends unasked (bits as in CiA 402).
std::vector<std::string> statusWordPhrases(std::uint16_t word);

/// Returns phrases for the status register SR. Source: Elmo MAN-SIMCR 4.5, table 3-45.
std::vector<std::string> statusRegisterPhrases(std::uint32_t bits);

/// Returns phrases for the motor fault MF, the reason why the drive switched its motor off; empty
/// for 0. Source: Elmo MAN-SIMCR 4.5; only bits 0 to 8 were available.
std::vector<std::string> motorFaultPhrases(std::uint32_t bits);

/// Returns the unit mode UM: "torque", "velocity", "position".
std::string unitModeWord(std::uint32_t mode);

}  // namespace terratact
