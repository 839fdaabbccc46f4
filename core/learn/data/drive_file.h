#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/learn/data/drive_lines.h"

namespace terratact {

inline constexpr std::size_t kMaxDriveLines = 1'000'000;  ///< of one file
inline constexpr std::size_t kMaxDriveFileBytes = std::size_t{256} << 20U;

/// Numbers of a file are multiples of this, in the units of its columns: 10 µm, 10 µrad, 10 µN.
inline constexpr double kDriveResolution = 1e-5;

/// Reads drives from CSV (core/store/csv_reader.h): a header, then one line of a drive per line.
/// Columns in any order:
///   run,t_s,kind,travelled_m   kind: "way" or "scene"
/// and the columns of scenes of one plane (core/learn/data/scene_file.h). With a column roll_rad they
/// are those of two tracks (core/learn/data/two_track_scene_file.h). A column turned_rad may hold the
/// heading [rad]; without the column the robot never turns. A way line has no heights. Lines of one
/// run stand together, and their time never falls.
/// Calls `add` for each drive when its last line is read, and holds one drive at a time. Returns
/// notices, such as unknown columns that were ignored.
/// Errors name file, line and cause: those of readScenes(), a line that breaks the rules above, more
/// than kMaxDriveLines lines or kMaxDriveFileBytes. `add` may have been called before.
Result<std::vector<Message>> readDrives(const std::string& path,
                                        const std::function<void(DriveLines&&)>& add);

struct DriveFile {
    std::vector<DriveLines> drives;
    std::vector<Message> notices;
};

/// Reads the same into memory: about 1 kB for each line.
Result<DriveFile> readDrives(const std::string& path);

/// Columns of a file of drives.
enum class DriveColumns : std::uint8_t {
    Simulated,  ///< heights are exact, and the robot never turns
    Measured,   ///< with the sd of heights and turned_rad
};

/// Returns the header of the file of drives in one plane, or on two tracks.
std::string drivesHeader(bool onePlane, DriveColumns columns = DriveColumns::Simulated);

/// Returns the lines of a drive below this header, rounded to kDriveResolution. Throws
/// std::invalid_argument for what the reader would refuse in one of these lines. A drive of one
/// plane whose sides differ throws it, too.
std::string driveText(const DriveLines& drive, DriveColumns columns = DriveColumns::Simulated);

/// Returns true if every reading and height of a line is within the range of its column.
bool isPlausible(const DriveLines& drive, const DriveLine& line);

}  // namespace terratact
