#pragma once

#include <gtest/gtest.h>

#include <cstddef>
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

/// Signals S0, S1 … of a message. S0 is a multiplexor; each of its values selects few of the others.
inline std::string multiplexedSignals(std::size_t count)
{
    std::string text = " SG_ S0 M : 0|8@1+ (1,0) [0|0] \"\" B\n";
    for (std::size_t i = 1; i < count; ++i)
        text += " SG_ S" + std::to_string(i) + " m" + std::to_string(i % 128)
              + " : 8|8@1+ (1,0) [0|0] \"\" B\n";
    return text;
}

inline CanFrame frameOfBytes(const std::vector<std::uint8_t>& bytes)
{
    CanFrame frame{.id = 256, .length = static_cast<std::uint8_t>(bytes.size())};
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    return frame;
}

}  // namespace terratact
