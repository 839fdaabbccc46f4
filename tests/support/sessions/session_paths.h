#pragma once

#include <algorithm>
#include <filesystem>

#include "core/log/session_reader.h"

/// Files of a folder of sessions, and their content.
namespace terratact {

inline std::vector<std::string> filesIn(const std::string& folder)
{
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

inline std::vector<std::uint64_t> numbersIn(SessionReader& reader)
{
    std::vector<std::uint64_t> numbers;
    for (std::size_t i = 0; i < reader.batches().size(); ++i)
        for (const FrameRow& row : reader.frames(i)) {
            std::uint64_t number = 0;
            for (std::size_t k = 0; k < 8; ++k)
                number |= std::uint64_t{row.frame.data[k]} << (8 * k);
            numbers.push_back(number);
        }
    return numbers;
}

inline bool hasEvent(const SessionReader& reader, EventKind kind, const std::string& subject)
{
    for (const EventRow& event : reader.events())
        if (event.kind == kind && event.subject == subject) return true;
    return false;
}

}  // namespace terratact
