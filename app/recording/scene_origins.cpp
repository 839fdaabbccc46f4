#include "app/recording/scene_origins.h"

#include "app/recording/session_text.h"
#include "app/runtime/print_text.h"

namespace terratact {

std::set<std::int64_t> SceneOrigins::add(const SessionReader& session)
{
    std::map<Key, std::string> added;
    std::set<std::int64_t> repeated;
    std::string first;
    for (const SceneRow& row : session.scenes()) {
        const Key key{wallTimeOf(session.start(), row.time),
                      featureValues(proprioception(row.measurement))};
        const auto before = fileOf_.find(key);
        if (before == fileOf_.end()) {
            added.emplace(key, session.path());
            continue;
        }
        if (repeated.empty()) first = before->second;
        repeated.insert(row.id);
    }
    fileOf_.merge(added);
    if (!repeated.empty())
        printText(
            stderr, "terratact: {}: {} of its {} scenes are in {} too{}: they are taken once\n",
            session.path(), repeated.size(), session.scenes().size(), first,
            repeated.size() == session.scenes().size() ? ", which is the same recording" : "");
    return repeated;
}

}  // namespace terratact
