#include "core/mapping/rotation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace terratact {

Rotation rotationOf(double x, double y, double z, double w)
{
    const double length = std::sqrt(x * x + y * y + z * z + w * w);
    if (!(length > 0.0) || !std::isfinite(length))
        throw std::invalid_argument("rotationOf: the quaternion has no direction");
    x /= length;
    y /= length;
    z /= length;
    w /= length;
    return {{{1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)},
             {2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)},
             {2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)}}};
}

Rotation rotationOfAngles(double roll, double pitch, double yaw)
{
    const double cr = std::cos(roll), sr = std::sin(roll);
    const double cp = std::cos(pitch), sp = std::sin(pitch);
    const double cy = std::cos(yaw), sy = std::sin(yaw);
    return {{{cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr},
             {sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr},
             {-sp, cp * sr, cp * cr}}};
}

Rotation product(const Rotation& a, const Rotation& b)
{
    Rotation c{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
    return c;
}

Rotation transposed(const Rotation& r)
{
    Rotation t{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) t[i][j] = r[j][i];
    return t;
}

BaseAngles baseAngles(const Rotation& base)
{
    // Columns are the base's axes. Its x axis rises with the nose, its y axis with the left side.
    return {.pitch = std::asin(std::clamp(base[2][0], -1.0, 1.0)),
            .roll = std::atan2(base[2][1], base[2][2]),
            .heading = std::atan2(base[1][0], base[0][0])};
}

}  // namespace terratact
