#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace terratact {

/// Counts which messages of each topic can be decoded. A damaged file may have some that cannot; a
/// wrong definition fits none.
class TopicDecoding {
public:
    void decoded(const std::string& topic) { ++counts_[topic].decoded; }
    void broken(const std::string& topic, const Error& error);
    std::uint64_t messages(const std::string& topic) const;  ///< that were decoded

    /// Returns the first error of a topic of which more messages are broken than decoded.
    /// Else adds a sentence to `remarks`, without the file's name, for each topic with broken ones.
    Status check(const std::string& path, std::vector<std::string>& remarks) const;

private:
    struct Counts {
        std::uint64_t decoded = 0, broken = 0;
        Error first{Message()};
    };
    std::map<std::string, Counts> counts_;
};

}  // namespace terratact
