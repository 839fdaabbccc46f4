#include "app/modelling/truth/truth_scenes.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/modelling/scene_kind.h"
#include "core/learn/data/drive_file.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

/// Reads drives, and takes their scenes.
Status addDrives(const std::string& path, TruthScenes& into)
{
    auto file = readDrives(path);
    if (!file) return file.error();
    into.notices = std::move(file->notices);
    into.drives = std::move(file->drives);
    for (const DriveLines& drive : into.drives) {
        into.isPlane = drive.onePlane;
        if (drive.onePlane)
            std::ranges::move(planeScenesOf(drive), std::back_inserter(into.plane));
        else
            std::ranges::move(trackScenesOf(drive), std::back_inserter(into.tracks));
    }
    return Done{};
}

template <class File, class SceneType>
Status addScenes(Result<File> file, std::vector<SceneType>& scenes, std::vector<Message>& notices)
{
    if (!file) return file.error();
    scenes = std::move(file->scenes);
    notices = std::move(file->notices);
    return Done{};
}

}  // namespace

Result<TruthScenes> readTruthScenes(const std::string& path)
{
    const auto kind = sceneKindOf(path);
    if (!kind) return kind.error();
    TruthScenes found{.isPlane = kind->isPlane};
    const Status read = kind->isDrives ? addDrives(path, found)
                      : kind->isPlane
                          ? addScenes(readScenes(path), found.plane, found.notices)
                          : addScenes(readTwoTrackScenes(path), found.tracks, found.notices);
    if (!read) return read.error();
    if (found.isPlane) found.tracks = onBothSides(found.plane);
    if (found.tracks.empty()) return fileError(path, "holds no scene");
    return found;
}

}  // namespace terratact
