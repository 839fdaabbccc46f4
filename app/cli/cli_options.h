#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/runtime/file_guard.h"
#include "core/infer/estimate/settings.h"
#include "core/infer/estimate/variant.h"

namespace terratact {

// What several subcommands declare their options with.

/// What a command does with a file: see CommandFiles.
enum class FileRole { Input, Output, Update };

/// The whole command line.  It knows which files each of its commands reads and writes.
class CommandLine : public CLI::App {
public:
    using CLI::App::App;

    /// The command reads or writes the files that `paths` lists once the arguments are parsed and its callback has run.
    void declare(const CLI::App& command, FileRole role, std::function<Paths()> paths);

    /// Of the commands that the arguments name.
    CommandFiles files() const;

private:
    struct Declaration {
        const CLI::App* command;
        FileRole role;
        std::function<Paths()> paths;
    };
    std::vector<Declaration> declarations_;
};

/// Declares files of a command.  `command` is below a CommandLine, else std::bad_cast.
void declareFiles(CLI::App& command, FileRole role, std::function<Paths()> paths);

/// An option with a file, or with several, that the command reads; "-" becomes /dev/stdin.
CLI::Option* addInput(CLI::App& app, const std::string& name, std::string& path,
                      const std::string& text);
CLI::Option* addInput(CLI::App& app, const std::string& name, Paths& paths,
                      const std::string& text);

/// An argument with a log of CAN frames, which the command reads as LogReader does, "-" included.
CLI::Option* addLog(CLI::App& app, const std::string& name, std::string& path,
                    const std::string& text);

/// --terrain: a file of profiles, or the name of ground that is made.
CLI::Option* addTerrain(CLI::App& app, std::string& terrain, const std::string& text);

/// An option with a text file that the command writes from its beginning to its end; "-" is the standard output.
CLI::Option* addTextOutput(CLI::App& app, const std::string& name, std::string& path,
                           const std::string& text);

/// An option with a file that the command writes under another name first: "-" and pipes are refused.
CLI::Option* addFileOutput(CLI::App& app, const std::string& name, std::string& path,
                           const std::string& text);

/// An option with a directory in which the command writes the files that `names` lists.
CLI::Option* addFolderOutput(CLI::App& app, const std::string& name, std::string& path,
                             const std::string& text, std::function<Paths()> names);

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
