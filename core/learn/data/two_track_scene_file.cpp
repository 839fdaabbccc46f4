#include "core/learn/data/two_track_scene_file.h"

#include <algorithm>
#include <stdexcept>

#include "core/learn/data/scene_file.h"
#include "core/learn/data/scene_rows.h"
#include "core/learn/data/scene_values.h"

namespace terratact {
Result<TwoTrackSceneFile> readTwoTrackScenes(const std::string& path)
{
    Result<CsvReader> csv = CsvReader::open(path);
    if (!csv) return csv.error();
    return readTwoTrackScenes(*std::move(csv));
}

Result<TwoTrackSceneFile> readTwoTrackScenes(CsvReader csv)
{
    if (const Result<bool> first = csv.next(); !first) return first.error();
    TwoTrackSceneFile file;
    if (std::ranges::find(csv.fields(), "roll_rad") == csv.fields().end()) {
        Result<SceneFile> plane = readScenesFromHere(std::move(csv));
        if (!plane) return plane.error();
        file.scenes = onBothSides(plane->scenes);
        file.notices = std::move(plane->notices);
        return file;
    }
    auto notices = readSceneRows(csv, twoTrackSceneColumns(), [&](const SceneFileRow& row) {
        file.scenes.push_back(twoTrackSceneOf(row));
        return Status(Done{});
    });
    if (!notices) return notices.error();
    file.notices = *std::move(notices);
    return file;
}

std::string twoTrackScenesText(const std::vector<TwoTrackScene>& scenes)
{
    if (scenes.size() > kMaxScenes)
        throw std::invalid_argument("writeScenes: more than " + std::to_string(kMaxScenes)
                                    + " scenes, which is what a file may hold");
    return sceneText(twoTrackSceneColumns(), scenes.size(),
                     [&](std::size_t k) { return sceneRow(scenes[k]); });
}

}  // namespace terratact
