#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <sstream>

#include "app/runtime/print_text.h"

namespace terratact {

/// Exit status of a program that was given wrong arguments.
inline constexpr int kWrongArguments = 2;

/// Parses the arguments of a program. Returns the exit status if it is to end: 0 after its help or version was printed,
/// kWrongArguments after a complaint. Both may quote arguments, and are printed as plain text.
inline std::optional<int> parseArguments(CLI::App& app, int argc, char** argv)
{
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        std::ostringstream out, complaint;
        const int code = app.exit(error, out, complaint);
        printText("{}", Lines(out.str()));
        printText(stderr, "{}", Lines(complaint.str()));
        return code == 0 ? 0 : kWrongArguments;
    }
}

}  // namespace terratact
