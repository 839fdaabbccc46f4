#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact::fuzz {

/// Aborts if a reader broke its header's promise; libFuzzer then keeps the input.
inline void promise(bool holds, std::string_view what)
{
    if (holds) return;
    std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(what.size()), what.data());
    std::abort();
}

/// Checks a refusal: one line that begins with the file's name and has no control characters.
inline void promiseRefusal(const Error& error, std::string_view name)
{
    promise(error.text.starts_with(std::string(name) + ": "), "a refusal names the file");
    promise(error.text.size() <= 20'000, "a refusal is short");
    for (const char c : error.text)
        promise(static_cast<unsigned char>(c) >= ' ' && c != '\x7f',
                "a refusal is one line without control characters");
}

inline std::string textOf(const unsigned char* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

}  // namespace terratact::fuzz
