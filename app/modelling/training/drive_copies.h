#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "core/learn/data/drive_lines.h"

namespace terratact {

/// Recognises drives that came before under another name or in another number format. A copy in training would make
/// the errors of the drives that are kept for them too small.
class DriveCopies {
public:
    /// Returns true if an earlier drive has as many lines, and the same readings in every scene but for
    /// kRewrittenReading. Otherwise remembers the drive. A drive without scenes is no copy.
    bool isCopy(const DriveLines& drive);

    /// Largest difference of a reading [rad], [m] that a number format of three decimals makes.
    static constexpr float kRewrittenReading = 0.0006F;

private:
    std::multimap<std::size_t, std::vector<float>> known_;  ///< readings of the scenes, by lines
};

}  // namespace terratact
