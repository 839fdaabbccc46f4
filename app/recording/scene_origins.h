#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/learn/data/columns.h"
#include "core/log/session_reader.h"

namespace terratact {

/// Finds the first file of each recorded scene, by its time [ns] since 1970 and its measurement. A copy or a part of a
/// session repeats scenes.
class SceneOrigins {
public:
    /// Adds a session's scenes. Returns the ids of scenes that an earlier session had, and prints their number on
    /// stderr.
    std::set<std::int64_t> add(const SessionReader& session);

private:
    using Key = std::pair<std::int64_t, FeatureValues>;
    std::map<Key, std::string> fileOf_;
};

}  // namespace terratact
