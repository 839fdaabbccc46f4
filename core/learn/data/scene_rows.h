#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/learn/data/columns.h"
#include "core/store/csv_reader.h"

namespace terratact {

// Rows of every kind of file of scenes or drives: a run, a time and numbers.

/// Numbers of a file of scenes or drives, after the columns run and t_s, and kind if it has kinds.
struct SceneColumns {
    std::vector<Column> columns;
    /// Words of the text column "kind", which is then required. Empty: there is no such column.
    std::vector<std::string_view> kinds;
    std::size_t most = 0;        ///< largest number of rows in a file
    std::size_t neverEmpty = 0;  ///< the first columns have a number in every row
    std::size_t required = 0;  ///< the first columns must be in the file, the others may be missing
    std::size_t written = 0;   ///< the first columns are written even if no row fills them
    std::vector<std::string_view> heightPrefixes;  ///< before the number in a height column: "h_"
    std::string_view heightColumns;                ///< names of the height columns, for an error
};

struct SceneFileRow {
    std::string run;
    double time = 0.0;                          ///< [s]
    std::size_t kind = 0;                       ///< index in SceneColumns::kinds
    std::vector<std::optional<double>> values;  ///< in the order of SceneColumns
};

/// Reads rows from a CSV whose current record is the header, and calls `add` for each. Returns
/// notices, such as unknown columns that were ignored. Errors are those of readScenes()
/// (core/learn/data/scene_file.h) and of `add`, which ends the reading. The row belongs to the
/// reader and is overwritten after `add`.
Result<std::vector<Message>> readSceneRows(CsvReader& csv, const SceneColumns& columns,
                                           const std::function<Status(const SceneFileRow&)>& add);

/// Returns a whole file of `count` rows. Columns after `written` that no row fills are left out. rowAt: called
/// twice for each number below count. Throws as sceneLine().
std::string sceneText(SceneColumns columns, std::size_t count,
                      const std::function<SceneFileRow(std::size_t)>& rowAt);

/// Returns the header of the file.
std::string sceneHeader(const SceneColumns& columns);

/// Returns a row as a line. Numbers are the shortest that read back equal. Throws
/// std::invalid_argument for what the reader would refuse.
std::string sceneLine(const SceneColumns& columns, const SceneFileRow& row);

}  // namespace terratact
