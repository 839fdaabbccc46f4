#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/infer/settings.h"
#include "core/infer/variant.h"

namespace terratact {

// What several subcommands declare their options with.

/// An option with a number, which shows its default.
CLI::Option* addNumber(CLI::App& app, const std::string& flag, auto& number,
                       const std::string& text)
{
    return app.add_option(flag, number, text)->capture_default_str();
}

/// An option that becomes the value which `parse` finds in its text.  One in which it finds none (an empty optional)
/// is refused with the complaint: "TEXT is none of …".
template <class Value, class Parse>
CLI::Option* addParsed(CLI::App& app, const std::string& flag, Value& value, Parse parse,
                       const std::string& kind, const std::string& complaint,
                       const std::string& text)
{
    const auto complain = [parse, complaint](const std::string& given) {
        return parse(given) ? std::string() : given + " " + complaint;
    };
    return app
        .add_option_function<std::string>(
            flag, [&value, parse](const std::string& given) { value = *parse(given); }, text)
        ->check(CLI::Validator(complain, kind));
}

/// An option that takes one of a set of names, "first|second|third".
template <class Value, class FromName>
CLI::Option* addChoice(CLI::App& app, const std::string& flag, Value& value, FromName fromName,
                       const std::string& names, const std::string& text)
{
    return addParsed(app, flag, value, fromName, names, "is none of " + names, text);
}

void addRobot(CLI::App& app, std::string& robot);  ///< --robot
void addModel(CLI::App& app, std::string& model);  ///< --model
void useShippedRobot(std::string& robot);          ///< where none is named
void useShippedModel(std::string& model);          ///< likewise

void addMethod(CLI::App& app, Settings& settings);
void addMethods(CLI::App& app, std::vector<std::string>& methods);
/// Each once, in the order given; all of them where none is.
std::vector<Method> methodsFrom(const std::vector<std::string>& names);

/// Options that all estimating commands share.
/// seconds: of sampling per estimate, at most.
void addSettings(CLI::App& app, Settings& settings, double& seconds);

}  // namespace terratact
