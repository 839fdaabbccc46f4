#pragma once

#include <string>

#include "core/base/result.h"

namespace terratact {

/// Kind of a file of scenes or drives, by its header.
struct SceneKind {
    bool isPlane = false;   ///< the file has no column roll_rad
    bool isDrives = false;  ///< the file has a column kind
};

/// Returns the kind of a file. Errors name a file that cannot be read.
Result<SceneKind> sceneKindOf(const std::string& path);

}  // namespace terratact
