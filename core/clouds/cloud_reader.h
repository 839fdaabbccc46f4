#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace terratact {

/// Point of a cloud [m], finite and within kFarthestPoint of the origin.
struct CloudPoint {
    double x = 0.0, y = 0.0, z = 0.0;
    bool operator==(const CloudPoint&) const = default;
};

inline constexpr double kFarthestPoint = 1e7;                        ///< [m]
inline constexpr std::size_t kCloudBlock = 8192;                     ///< points of a block
inline constexpr std::uint64_t kMaxCloudPoints = 1'000'000'000'000;  ///< that a header may declare

/// Points of a file, one block at a time: memory does not grow with the file. Nothing in the file is
/// trusted.
///
///     for (std::vector<CloudPoint> block;;) {
///         const Result<bool> more = cloud->next(block);
///         if (!more) return more.error();
///         if (!*more) break;
///         … block …
///     }
class CloudReader {
public:
    virtual ~CloudReader() = default;
    CloudReader(const CloudReader&) = delete;
    CloudReader& operator=(const CloudReader&) = delete;

    virtual std::string_view format() const = 0;  ///< "PCD, binary", …

    /// Replaces `block` by the next points, which may be none. Returns false after the last. Errors name the file, the
    /// line or the byte, what was expected and what to do. A file that ends before the points that its header declares
    /// is an error.
    virtual Result<bool> next(std::vector<CloudPoint>& block) = 0;

    std::uint64_t points() const { return points_; }  ///< points read so far
    /// Points left out so far: a coordinate is NaN, infinite, or farther than kFarthestPoint.
    std::uint64_t leftOut() const { return leftOut_; }
    /// Returns what is unusual in the file, after its last point, without the file's name; empty: nothing.
    const std::string& remark() const { return remark_; }

protected:
    CloudReader() = default;
    /// Adds a point to the block, or counts it as left out.
    void add(std::vector<CloudPoint>& block, const CloudPoint& point);
    void setRemark(std::string text) { remark_ = std::move(text); }

private:
    std::uint64_t points_ = 0, leftOut_ = 0;
    std::string remark_;
};

/// Opens a cloud by its content, whatever its name:
///   PCD   versions 0.5 to 0.7; ascii, binary, binary_compressed; fields x, y, z of any number type
///   PLY   version 1.0; ascii, little and big endian; properties x, y, z of the element vertex
///   text  x y z and any more columns, separated by blanks, commas, semicolons or tabs; a first line may
///         name the columns, and may be a number alone, as in PTS; lines with # or // are comments
/// Errors name the file, the line, what was expected and what to do.
Result<std::unique_ptr<CloudReader>> openCloud(const std::string& path);

}  // namespace terratact
