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
    SceneColumns columns = twoTrackSceneColumns();
    std::vector<SceneFileRow> rows;
    rows.reserve(scenes.size());
    std::vector<bool> used(columns.columns.size(), false);
    std::fill_n(used.begin(), columns.required, true);
    for (const TwoTrackScene& scene : scenes) {
        rows.push_back(sceneRow(scene));
        for (std::size_t i = 0; i < used.size(); ++i)
            used[i] = used[i] || rows.back().values[i].has_value();
    }
    const auto withoutUnused = [&](auto& values) {
        std::size_t i = 0;
        std::erase_if(values, [&](const auto&) { return !used[i++]; });
    };
    withoutUnused(columns.columns);
    std::string content = sceneHeader(columns);
    for (SceneFileRow& row : rows) {
        withoutUnused(row.values);
        content += sceneLine(columns, row);
    }
    return content;
}

}  // namespace terratact
