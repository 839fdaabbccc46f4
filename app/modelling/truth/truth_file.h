#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/modelling/truth/laser_truth.h"
#include "app/modelling/truth/truth_slice.h"
#include "core/base/result.h"
#include "core/store/file_write.h"

namespace terratact {

class SqliteFile;

inline constexpr std::int64_t kTruthApplicationId = 0x54545431;  ///< "TTT1", of the SQLite header
inline constexpr std::size_t kMaxTruthScenes = 20'000;

/// Makes a truth file (SQLite, docs/truth.md). It holds the robot, every scene with its heights, and the reasons for
/// missing heights. It also holds the cells of each scene's cloud, so that heights and slices can be sampled again. The
/// cells of all scenes have at most SceneGrid::kMaxSamples heights of 4 bytes. robotFile: read again. The file is
/// complete under a temporary name: commit() renames it. Errors name the file: too many scenes, or what SQLite and
/// file_write.h refuse.
Result<NewFile> newTruthFile(const std::string& path, const LaserTruth& truth,
                             const std::string& robotFile);

/// A truth file of any source. open() reads the scenes; cells are read on demand. Files of the first version hold
/// slices to 1 mm instead of cells. One thread at a time.
class TruthFile {
public:
    /// Errors name the file: another kind or version, a damaged one, a scene or a robot that is refused.
    static Result<TruthFile> open(const std::string& path);
    TruthFile(TruthFile&& other) noexcept;
    TruthFile& operator=(TruthFile&& other) noexcept;
    TruthFile(const TruthFile&) = delete;
    TruthFile& operator=(const TruthFile&) = delete;
    ~TruthFile();

    /// Returns the truth without its grid, cloud statistics and remarks.
    const LaserTruth& truth() const { return truth_; }
    /// Returns the slice of a row from 0. Errors name the file and the row.
    Result<std::vector<SlicePoint>> slice(std::size_t row);
    /// Returns false for a file of the first version, whose heights cannot be sampled again.
    bool hasCells() const { return version_ > 1; }
    /// Returns the grid with the cells of a row alone, whose place is 0. Errors name the file and the row. The
    /// file is of the first version or damaged, or the scene has no place in the cloud.
    Result<SceneGrid> grid(std::size_t row);
    const std::string& path() const { return path_; }

private:
    TruthFile(std::string path, SqliteFile file);
    void read();
    void readRule();
    void readCorrections();
    std::vector<SlicePoint> storedSlice(std::size_t row);
    SceneGrid gridOf(std::size_t row);

    std::string path_;
    std::unique_ptr<SqliteFile> file_;
    std::int64_t version_ = 0;
    LaserTruth truth_{};
};

}  // namespace terratact
