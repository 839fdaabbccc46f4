#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace terratact {

/// A picture that was read back.
struct Picture {
    int width = 0, height = 0;
    std::vector<unsigned> pixels;  ///< 0xRRGGBB, row by row

    unsigned at(int x, int y) const
    {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
                      + static_cast<std::size_t>(x)];
    }

    /// Returns the number of pixels with exactly this colour.
    long count(unsigned rgb) const { return std::count(pixels.begin(), pixels.end(), rgb); }

    /// Returns left, right, top, bottom of the pixels with exactly this colour; {width, −1, height, −1} for none.
    std::array<int, 4> extent(unsigned rgb) const
    {
        std::array<int, 4> found{width, -1, height, -1};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (at(x, y) == rgb)
                    found = {std::min(found[0], x), std::max(found[1], x), std::min(found[2], y),
                             std::max(found[3], y)};
        return found;
    }
};

/// Reads a PNG; throws std::runtime_error if the file is not one.
Picture readPng(const std::string& path);

}  // namespace terratact
