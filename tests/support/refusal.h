#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// Checks that the result is an error of one line that begins with the file's path and contains every part.
template <class T>
testing::AssertionResult refused(const Result<T>& result, const std::string& path,
                                 std::initializer_list<std::string_view> parts)
{
    if (result) return testing::AssertionFailure() << path << " was accepted";
    const std::string& text = result.error().text;
    if (!text.starts_with(path + ": "))
        return testing::AssertionFailure() << "does not name the file: " << text;
    if (text.find('\n') != std::string::npos)
        return testing::AssertionFailure() << "is more than one line: " << text;
    for (const std::string_view part : parts)
        if (text.find(part) == std::string::npos)
            return testing::AssertionFailure() << "does not say \"" << part << "\": " << text;
    return testing::AssertionSuccess() << text;
}

}  // namespace terratact
