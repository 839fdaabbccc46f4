#include "app/modelling/scene_kind.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/learn/data/drive_file.h"
#include "core/store/csv_reader.h"

namespace terratact {

Result<SceneKind> sceneKindOf(const std::string& path)
{
    auto text = CsvReader::textOf(path, kMaxDriveFileBytes);
    if (!text) return text.error();
    auto csv = CsvReader::over(path, *std::move(text));
    if (!csv) return csv.error();
    if (const auto first = csv->next(); !first) return first.error();
    const auto has = [&](std::string_view column) {
        return std::ranges::find(csv->fields(), column) != csv->fields().end();
    };
    return SceneKind{.isPlane = !has("roll_rad"), .isDrives = has("kind")};
}

}  // namespace terratact
