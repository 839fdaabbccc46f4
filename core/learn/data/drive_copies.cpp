#include "core/learn/data/drive_copies.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/robot/two_tracks.h"
#include "core/store/canonical_bytes.h"
#include "core/store/sha256.h"

namespace terratact {
namespace {

std::uint32_t markOf(const Measurement& scene)
{
    CanonicalBytes bytes;
    const auto addRounded = [&bytes](double value) { bytes.add(std::round(value / kMarkStep)); };
    const TwoTrackReadings s = twoTrackReadings(scene);
    addRounded(s.pitch);
    for (const double angle : s.flippers) addRounded(angle);
    addRounded(scene.travelled.value_or(0.0));
    Sha256 hash;
    hash.add(bytes.bytes());
    std::uint32_t mark = 0;
    for (const char byte : hash.finish().substr(0, sizeof mark))
        mark = mark << 8U | static_cast<unsigned char>(byte);
    return mark;
}

}  // namespace

DriveMarks driveMarks(const DriveLines& drive)
{
    std::set<std::uint32_t> marks;
    for (const DriveLine& line : drive.lines)
        if (line.isScene && marks.size() < kMaxDriveMarks) marks.insert(markOf(line.line));
    return {marks.begin(), marks.end()};
}

std::map<std::size_t, std::size_t> DriveCopies::sharedBy(const DriveMarks& marks) const
{
    std::map<std::size_t, std::size_t> shared;
    for (const std::uint32_t mark : marks) {
        const auto [first, last] = drivesOf_.equal_range(mark);
        for (auto known = first; known != last; ++known) ++shared[known->second];
    }
    return shared;
}

bool DriveCopies::contains(const DriveMarks& marks) const
{
    return std::ranges::any_of(sharedBy(marks), [&](const auto& of) {
        return 2 * of.second >= std::min(marks.size(), drives_[of.first].size());
    });
}

void DriveCopies::add(DriveMarks marks)
{
    for (const std::uint32_t mark : marks) drivesOf_.emplace(mark, drives_.size());
    drives_.push_back(std::move(marks));
}

bool DriveCopies::isCopy(const DriveLines& drive)
{
    DriveMarks marks = driveMarks(drive);
    const auto shared = sharedBy(marks);
    if (std::ranges::any_of(shared, [&](const auto& of) { return 2 * of.second >= marks.size(); }))
        return true;
    if (!marks.empty()) add(std::move(marks));
    return false;
}

}  // namespace terratact
