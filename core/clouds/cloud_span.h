#pragma once

#include <array>
#include <span>
#include <string>

#include "core/clouds/cloud_reader.h"

namespace terratact {

/// Smallest box around points, along the axes of their frame.
class CloudSpan {
public:
    void add(std::span<const CloudPoint> points);
    bool isEmpty() const { return least_[0] > most_[0]; }
    /// Returns the longest edge [m]; 0 without points.
    double width() const;
    /// Returns the sentence that no point of the cloud lies where the robot drove, with a guess at the cause.
    std::string farFrom(const CloudSpan& robot) const;

private:
    /// Returns "x -1.00 to 2.00, y …, z … m".
    std::string text() const;

    std::array<double, 3> least_{1e300, 1e300, 1e300}, most_{-1e300, -1e300, -1e300};
};

}  // namespace terratact
