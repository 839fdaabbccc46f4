#pragma once

#include <array>
#include <optional>

namespace terratact {

inline constexpr int kBins = 11;
inline constexpr double kBinWidth = 0.1;  ///< [m]

/// One height per bin, rear to front [m], DEM frame: origin at the IMU, axes along gravity, z up.
/// A bin's height is the mean of the terrain over its 0.1 m.
using Heights = std::array<double, kBins>;

/// Heights of which some are unknown: empty, never NaN.
using OptionalHeights = std::array<std::optional<double>, kBins>;

/// Returns x of the centre of bin i [m].
constexpr double binCentre(int i)
{
    return (static_cast<double>(i) - 3.0) / 10.0;
}

/// Return the borders of bin i [m].
constexpr double binBegin(int i)
{
    return (static_cast<double>(i) - 3.5) / 10.0;
}
constexpr double binEnd(int i)
{
    return binBegin(i + 1);
}

/// Returns the bin that contains x [m]; empty outside [-0.35, 0.75).
constexpr std::optional<int> binOf(double x)
{
    for (int i = 0; i < kBins; ++i)
        if (x >= binBegin(i) && x < binEnd(i)) return i;
    return std::nullopt;
}

}  // namespace terratact
