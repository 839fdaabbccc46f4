#include "core/learn/data/scene_file.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "core/learn/data/columns.h"
#include "core/learn/data/scene_rows.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sha256.h"

namespace terratact {
namespace {

/// Returns features and heights of one plane; pitch and the flipper angles are never empty.
const SceneColumns& planeColumns()
{
    static const SceneColumns columns = [] {
        SceneColumns c{.columns = {featureColumns().begin(), featureColumns().end()},
                       .neverEmpty = 3,
                       .required = kFeatures,
                       .heightPrefixes = {"h_"},
                       .heightColumns = "h_-0.3_m … h_+0.0_m … h_+0.7_m"};
        c.columns.insert(c.columns.end(), heightColumns().begin(), heightColumns().end());
        return c;
    }();
    return columns;
}

Scene sceneOf(SceneFileRow& row)
{
    FeatureValues features{};
    OptionalHeights truth{};
    std::copy_n(row.values.begin(), features.size(), features.begin());
    std::copy_n(row.values.begin() + kFeatures, truth.size(), truth.begin());
    return Scene{row.run, row.time, proprioception(features), truth};
}

SceneFileRow rowOf(const Scene& scene)
{
    SceneFileRow row{scene.run, scene.time, {}};
    const FeatureValues features = featureValues(scene.s);
    row.values.assign(features.begin(), features.end());
    row.values.insert(row.values.end(), scene.truth.begin(), scene.truth.end());
    return row;
}

}  // namespace

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
    auto notices = readSceneRows(csv, planeColumns(),
                                 [&](SceneFileRow& row) { file.scenes.push_back(sceneOf(row)); });
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
    std::string content = sceneHeader(planeColumns());
    for (const Scene& scene : scenes) content += sceneLine(planeColumns(), rowOf(scene));
    return content;
}

Status writeScenes(const std::string& path, const std::vector<Scene>& scenes)
{
    return writeFileAtomically(path, scenesText(scenes));
}

}  // namespace terratact
