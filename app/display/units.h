#pragma once

#include <cstdint>
#include <string_view>

namespace terratact {

/// Units in which the console shows lengths and angles. Files and commands hold SI units always.
enum class LengthUnit : std::uint8_t { Metre, Centimetre };
enum class AngleUnit : std::uint8_t { Degree, Radian };

struct Units {
    LengthUnit length = LengthUnit::Metre;
    AngleUnit angle = AngleUnit::Degree;
    bool operator==(const Units&) const = default;
};

/// Returns the units in use. GUI thread only.
const Units& units();

/// Sets the units before the first window is made: texts that are shown already do not follow.
void setUnits(const Units& units);

/// Return the names in the preferences file: "m", "cm"; "deg", "rad".
std::string_view name(LengthUnit unit);
std::string_view name(AngleUnit unit);

}  // namespace terratact
