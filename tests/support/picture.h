#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace terratact {

/// A picture as it was written, for tests.
struct Picture {
    int width = 0, height = 0;
    std::vector<unsigned> pixels;  ///< 0xRRGGBB, row by row

    unsigned at(int x, int y) const
    {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
                      + static_cast<std::size_t>(x)];
    }

    /// How many pixels have exactly this colour.
    long count(unsigned rgb) const { return std::count(pixels.begin(), pixels.end(), rgb); }

    /// Left, right, top, bottom of the pixels of exactly this colour; {width, −1, height, −1} for none.
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

/// Throws std::runtime_error where the file is no PNG.
Picture readPng(const std::string& path);

}  // namespace terratact
