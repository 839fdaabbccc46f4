#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/learn/data/drive_lines.h"

namespace terratact {

/// Marks of the scenes of a drive, ascending, each once. The mark of a scene is the first 32 bits of a SHA-256. It
/// covers pitch, flipper angles [rad] and way [m], rounded to kMarkStep. Run, time and way lines do not count, nor do
/// digits that a number format of three decimals drops.
using DriveMarks = std::vector<std::uint32_t>;
inline constexpr double kMarkStep = 0.001;
inline constexpr std::size_t kMaxDriveMarks = 100'000;  ///< of one drive; later scenes have none

DriveMarks driveMarks(const DriveLines& drive);

/// Recognises drives that occurred before under another name, in another number format, or with other lines. A
/// copy in training would make the errors of the drives that are kept for them too small.
class DriveCopies {
public:
    /// Returns true if an earlier drive has at least half of this drive's marks. Otherwise remembers the
    /// drive. A drive without scenes is no copy, and nothing to remember.
    bool isCopy(const DriveLines& drive);

    /// Returns true if an earlier drive shares at least half of the marks of the shorter of both drives. One was then
    /// cut from the other. Remembers nothing.
    bool contains(const DriveMarks& marks) const;
    /// Remembers a drive by its marks.
    void add(DriveMarks marks);

    /// Returns the marks of the drives that it remembers, in order.
    const std::vector<DriveMarks>& drives() const { return drives_; }

private:
    /// Returns the number of these marks that each earlier drive has, too.
    std::map<std::size_t, std::size_t> sharedBy(const DriveMarks& marks) const;

    std::vector<DriveMarks> drives_;
    std::unordered_multimap<std::uint32_t, std::size_t> drivesOf_;  ///< of a mark
};

}  // namespace terratact
