#include "core/learn/data/scene_file.h"

#include <algorithm>
#include <stdexcept>

#include "core/learn/data/scene_rows.h"
#include "core/learn/data/scene_values.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sha256.h"

namespace terratact {
Result<SceneFile> readScenes(const std::string& path)
{
    Result<std::string> text = CsvReader::textOf(path);
    if (!text) return text.error();
    std::string hash = sha256Hex(*text);
    Result<CsvReader> csv = CsvReader::over(path, *std::move(text));
    if (!csv) return csv.error();
    Result<SceneFile> file = readScenes(*std::move(csv));
    if (file) file->hash = std::move(hash);
    return file;
}

Result<SceneFile> readScenes(CsvReader csv)
{
    if (const Result<bool> first = csv.next(); !first) return first.error();
    return readScenesFromHere(std::move(csv));
}

Result<SceneFile> readScenesFromHere(CsvReader csv)
{
    SceneFile file;
    auto notices = readSceneRows(csv, planeSceneColumns(), [&](const SceneFileRow& row) {
        file.scenes.push_back(planeSceneOf(row));
        return Status(Done{});
    });
    if (!notices) return notices.error();
    file.notices = *std::move(notices);
    return file;
}

Result<SceneFile> readScenesWithTruth(const std::string& path)
{
    auto file = readScenes(path);
    if (!file) return file;
    const std::size_t left = std::erase_if(file->scenes, [](const Scene& scene) {
        return std::ranges::none_of(scene.truth, [](const auto& h) { return h.has_value(); });
    });
    if (file->scenes.empty())
        return fileError(
            path, TR_NOOP("core", "no scene has a known height (columns h_-0.3_m … h_+0.7_m)"));
    if (left > 0)
        file->notices.emplace_back(TR_NOOP("core", "%1 scenes without any known height left out"),
                                   left);
    return file;
}

std::string scenesText(const std::vector<Scene>& scenes)
{
    if (scenes.size() > kMaxScenes)
        throw std::invalid_argument("writeScenes: more than " + std::to_string(kMaxScenes)
                                    + " scenes, which is what a file may hold");
    return sceneText(planeSceneColumns(), scenes.size(),
                     [&](std::size_t k) { return sceneRow(scenes[k]); });
}

Status writeScenes(const std::string& path, const std::vector<Scene>& scenes)
{
    return writeFileAtomically(path, scenesText(scenes));
}

}  // namespace terratact
