#pragma once

#include <string>
#include <vector>

namespace terratact {

/// Returns the path of a shipped file, for example "robots/absolem.toml". It lies in share/terratact beside the folder
/// of the running program, wherever that was installed, moved or unpacked. In a build tree that is a link to the
/// sources' resources. No path of the build machine is compiled in. The reader of the file reports a missing file.
/// Throws std::filesystem::filesystem_error without /proc.
std::string resourcePath(const std::string& name);

/// Returns the path of the shipped model, default.ttm, which holds two tracks and one plane. Without it
/// the console estimates nothing and says so in an alarm; the command line ends with readModel()'s error.
std::string shippedModelPath();

/// Returns the path of the shipped networks of the method trail, default.ttn.
std::string shippedTrailPath();

/// Returns the path of the networks that belong to a model: the same with the ending .ttn.
std::string trailPathBeside(const std::string& modelPath);

/// Returns the paths of all shipped models: default.ttm, and one_plane.ttm, the model of recordings from before it.
std::vector<std::string> shippedModelPaths();

}  // namespace terratact
