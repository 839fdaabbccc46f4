#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace terratact {

// What the bits that an Absolem's drives report mean, one phrase for each that says something; a bit without a
// known meaning is named by its value.

/// The status word that a drive sends unasked (bits as in CiA 402).
std::vector<std::string> statusWordPhrases(std::uint16_t word);

/// The status register SR.  Source: Elmo MAN-SIMCR 4.5, table 3-45.
std::vector<std::string> statusRegisterPhrases(std::uint32_t bits);

/// The motor fault MF: why the drive has switched its motor off; empty for 0.  Source: Elmo MAN-SIMCR 4.5,
/// of which bits 0 to 8 were at hand.
std::vector<std::string> motorFaultPhrases(std::uint32_t bits);

/// The unit mode UM: "torque", "velocity", "position".
std::string unitModeWord(std::uint32_t mode);

}  // namespace terratact
