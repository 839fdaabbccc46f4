// Fuzzes scenes as CSV. Accepted values are finite and within the columns' ranges, and survive writing and reading.
#include "core/learn/data/scene_file.h"

#include <cmath>
#include <cstdint>

#include "core/learn/data/columns.h"
#include "tests/fuzz/promise.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

void promiseScene(const Scene& scene)
{
    promise(std::isfinite(scene.time), "a time is finite");
    const FeatureValues values = featureValues(scene.s);
    for (std::size_t i = 0; i < values.size(); ++i)
        promise(!values[i] || featureColumns()[i].holds(*values[i]), "a feature is in its range");
    for (std::size_t i = 0; i < scene.truth.size(); ++i)
        promise(!scene.truth[i] || heightColumns()[i].holds(*scene.truth[i]),
                "a height is in its range");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Result<CsvReader> csv = CsvReader::over("f", textOf(data, size));
    if (!csv) return promiseRefusal(csv.error(), "f"), 0;
    const Result<SceneFile> file = readScenes(*std::move(csv));
    if (!file) return promiseRefusal(file.error(), "f"), 0;
    promise(!file->scenes.empty(), "a file holds a scene");
    for (const Scene& scene : file->scenes) promiseScene(scene);

    const Result<SceneFile> again = readScenes(*CsvReader::over("g", scenesText(file->scenes)));
    promise(again && again->scenes == file->scenes && again->notices.empty(),
            "scenes survive being written and read");
    return 0;
}
