#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/learn/data/columns.h"
#include "core/log/session_reader.h"

namespace terratact {

/// Which file each recorded scene came from first, by its time [ns] since 1970 and what was measured then: a copy of a
/// session, or a part of it in another one, has them again.
class SceneOrigins {
public:
    /// Takes a session's scenes.  Those that an earlier session had, by their ids; how many is said on stderr.
    std::set<std::int64_t> take(const SessionReader& session);

private:
    using Key = std::pair<std::int64_t, FeatureValues>;
    std::map<Key, std::string> fileOf_;
};

}  // namespace terratact
