#include "core/clouds/cloud_span.h"

#include <fmt/format.h>

#include <algorithm>

namespace terratact {

void CloudSpan::add(std::span<const CloudPoint> points)
{
    for (const CloudPoint& point : points) {
        const std::array<double, 3> xyz{point.x, point.y, point.z};
        for (std::size_t k = 0; k < xyz.size(); ++k) {
            least_.at(k) = std::min(least_.at(k), xyz.at(k));
            most_.at(k) = std::max(most_.at(k), xyz.at(k));
        }
    }
}

double CloudSpan::width() const
{
    double widest = 0.0;
    for (std::size_t k = 0; k < least_.size(); ++k)
        widest = std::max(widest, most_.at(k) - least_.at(k));
    return widest;
}

std::string CloudSpan::farFrom(const CloudSpan& robot) const
{
    const bool isLarger = width() > 100.0 * (1.0 + robot.width());
    return fmt::format("no point lies under a scene: the cloud's are within {}, the robot within "
                       "{}: correct the poses or their frame{}",
                       text(), robot.text(), isLarger ? ", or is the cloud in mm?" : "");
}

std::string CloudSpan::text() const
{
    return fmt::format("x {:.2f} to {:.2f}, y {:.2f} to {:.2f}, z {:.2f} to {:.2f} m", least_[0],
                       most_[0], least_[1], most_[1], least_[2], most_[2]);
}

}  // namespace terratact
