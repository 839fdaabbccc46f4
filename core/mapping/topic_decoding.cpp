#include "core/mapping/topic_decoding.h"

#include <fmt/format.h>

namespace terratact {

void TopicDecoding::broken(const std::string& topic, const Error& error)
{
    Counts& counts = counts_[topic];
    if (counts.broken++ == 0) counts.first = error;
}

std::uint64_t TopicDecoding::messages(const std::string& topic) const
{
    const auto found = counts_.find(topic);
    return found == counts_.end() ? 0 : found->second.decoded;
}

Status TopicDecoding::check(const std::string& path, std::vector<std::string>& remarks) const
{
    for (const auto& [topic, counts] : counts_) {
        if (counts.broken > counts.decoded) return counts.first;
        if (counts.broken == 0) continue;
        std::string first = counts.first.text;
        if (first.starts_with(path)) first.erase(0, path.size() + 2);
        remarks.push_back(
            fmt::format("{} of {} messages cannot be decoded and are left out; the first: {}",
                        counts.broken, counts.broken + counts.decoded, first));
    }
    return Done{};
}

}  // namespace terratact
