#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/store/file_write.h"

namespace terratact {

/// Writes a file of this content, or returns why not.
using FileWriter = std::function<Status(const std::string& path, std::string_view content)>;

/// Files that belong together: all of them are written, or none. add() writes a temporary file
/// beside each path; commit() renames them all. Without commit(), no file changes.
///
///     FileGroup files;
///     if (Status s = files.add("poses.csv", poses); !s) return s;
///     if (Status s = files.add("cloud.pcd", cloud); !s) return s;
///     return files.commit();
class FileGroup {
public:
    /// Writes the content to the disk under a temporary name. Errors: as writeFileAtomically().
    Status add(const std::string& path, std::string_view content);

    /// Takes a file that is filled already.
    void add(NewFile filled) { files_.push_back(std::move(filled)); }

    /// Renames every file, in the order of add(). An error of the directory itself may still leave
    /// the first ones renamed: all contents are on the disk by then.
    Status commit();

    /// Returns add() as a function, for code that draws or prints files.
    FileWriter writer()
    {
        return [this](const std::string& path, std::string_view content) {
            return add(path, content);
        };
    }

private:
    std::vector<NewFile> files_;
};

}  // namespace terratact
