#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/wire/dbc/dbc.h"
#include "core/wire/dbc/dbc_file.h"

/// DBC files as text, and frames for them.
namespace terratact {

inline Result<DbcFile> parsed(const std::string& text)
{
    return dbcFrom("f.dbc", text);
}

inline DbcMessage onlyMessage(const std::string& text)
{
    const Result<DbcFile> file = parsed(text);
    EXPECT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->messages.size(), 1U);
    return file->messages.at(0);
}

/// A signal of an eight-byte message.
inline DbcSignal onlySignal(const std::string& place, const std::string& more = {})
{
    return onlyMessage("BO_ 256 M: 8 A\n SG_ S : " + place + " [0|0] \"\" B\n" + more)
        .payload.at(0);
}

inline CanFrame frameOfBytes(const std::vector<std::uint8_t>& bytes)
{
    CanFrame frame{.id = 256, .length = static_cast<std::uint8_t>(bytes.size())};
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    return frame;
}

}  // namespace terratact
