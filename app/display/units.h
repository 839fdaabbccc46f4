#pragma once

#include <QString>
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

/// A unit in use, and how many of it are one of the SI unit.
struct ShownUnit {
    QString name;
    double factor = 1.0;
};

/// Returns the unit in use for values in "m", "m/s", "rad" or "rad/s"; another unit stays as it is.
ShownUnit shownUnit(std::string_view si);

/// Return the names in the preferences file: "m", "cm"; "deg", "rad".
std::string_view name(LengthUnit unit);
std::string_view name(AngleUnit unit);

}  // namespace terratact
