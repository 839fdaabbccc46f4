#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "app/runtime/print_text.h"
#include "core/base/text.h"

namespace terratact {

/// Exit status of a program that failed, and of one that was given wrong arguments.
inline constexpr int kFailed = 1, kWrongArguments = 2;

/// Throws for the numbers that CLI11's ranges let through: nan, infinity, and whole numbers that are
/// negative or too large for 64 bits.
inline void refuseImpossibleNumbers(const CLI::App& app)
{
    for (const CLI::Option* const option : app.get_options()) {
        const std::string type = option->get_type_name();
        const bool isReal = type.rfind("FLOAT", 0) == 0, isWhole = type.rfind("UINT", 0) == 0;
        if (!isReal && !isWhole) continue;
        for (const std::string& text : option->results()) {
            if (isReal && !std::isfinite(std::strtod(text.c_str(), nullptr)))
                throw CLI::ValidationError(option->get_name(),
                                           text + " is no number within the range of numbers");
            if (isWhole && !integerFrom<std::uint64_t>(text))
                throw CLI::ValidationError(
                    option->get_name(),
                    text + " is no whole number from 0 to 18446744073709551615");
        }
    }
    for (const CLI::App* const below : app.get_subcommands()) refuseImpossibleNumbers(*below);
}

/// Throws for words that no option or subcommand takes, in the order of the arguments.
inline void refuseUnknownWords(const CLI::App& app)
{
    std::vector<std::string> unknown = app.remaining(true);
    if (unknown.empty()) return;
    std::reverse(unknown.begin(), unknown.end());  // CLI11 joins them from the last to the first
    throw CLI::ExtrasError(unknown);
}

/// Parses the arguments, and throws for impossible numbers. Since CLI11 2.4, some of these fail while they are parsed,
/// without a reason. An unknown word is reported before a missing one: "simulat" is why no subcommand is found.
inline void parseNumbers(CLI::App& app, int argc, char** argv)
{
    try {
        app.parse(argc, argv);
    } catch (const CLI::ConversionError&) {
        refuseImpossibleNumbers(app);
        throw;
    } catch (const CLI::RequiredError&) {
        refuseUnknownWords(app);
        throw;
    } catch (const CLI::ExtrasError&) {
        refuseUnknownWords(app);
        throw;
    }
    refuseImpossibleNumbers(app);
}

/// Returns CLI11's message of an error as one line, whatever arguments it quotes.
inline std::string complaintOf(const CLI::App* app, const CLI::Error& error)
{
    return CLI::FailureMessage::simple(
        app, {error.get_name(), printable(error.what()), error.get_exit_code()});
}

/// Parses the arguments of a program. Returns the exit status if the program must end: 0 after printing help or
/// version, kWrongArguments after an error. The error may quote arguments, and is printed as plain text.
inline std::optional<int> parseArguments(CLI::App& app, int argc, char** argv)
{
    try {
        parseNumbers(app, argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        app.failure_message(complaintOf);
        std::ostringstream out, complaint;
        const int code = app.exit(error, out, complaint);
        printText("{}", Lines(out.str()));
        printText(stderr, "{}", Lines(complaint.str()));
        return code == 0 ? 0 : kWrongArguments;
    }
}

/// Lets a file that reaches the limit of `ulimit -f` be an error like a full disk. By default the
/// system ends the program there, with half of the file written.
inline void reportFileSizeLimit()
{
    (void)std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace terratact
