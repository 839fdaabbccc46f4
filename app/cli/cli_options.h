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

// Option declarations that several subcommands share.

/// Role of a file in a command, see CommandFiles.
enum class FileRole { Input, Output, Session, Update };

/// The whole command line, with the files that each command reads and writes.
class CommandLine : public CLI::App {
public:
    using CLI::App::App;

    /// Declares files of a command. `paths` is called after the arguments are parsed and the command's callback has
    /// run.
    void declare(const CLI::App& command, FileRole role, std::function<Paths()> paths);

    /// Returns the files of the commands named by the arguments.
    CommandFiles files() const;

private:
    struct Declaration {
        const CLI::App* command;
        FileRole role;
        std::function<Paths()> paths;
    };
    std::vector<Declaration> declarations_;
};

/// Declares files of a command. Throws std::bad_cast unless `command` is below a CommandLine.
void declareFiles(CLI::App& command, FileRole role, std::function<Paths()> paths);

/// Adds an option for one or several input files; "-" becomes /dev/stdin.
CLI::Option* addInput(CLI::App& app, const std::string& name, std::string& path,
                      const std::string& text);
CLI::Option* addInput(CLI::App& app, const std::string& name, Paths& paths,
                      const std::string& text);

/// Adds an argument for a CAN log, read by LogReader; "-" is allowed.
CLI::Option* addLog(CLI::App& app, const std::string& name, std::string& path,
                    const std::string& text);

/// Adds --terrain: a profile file, or the name of generated ground.
CLI::Option* addTerrain(CLI::App& app, std::string& terrain, const std::string& text);

/// Adds an option for a text output that is written sequentially; "-" is standard output.
CLI::Option* addTextOutput(CLI::App& app, const std::string& name, std::string& path,
                           const std::string& text);

/// Adds an option for an output file that is written under a temporary name, so "-" and pipes are refused.
CLI::Option* addFileOutput(CLI::App& app, const std::string& name, std::string& path,
                           const std::string& text);

/// Adds an option for a session that is written, as addFileOutput().
CLI::Option* addSessionOutput(CLI::App& app, const std::string& name, std::string& path,
                              const std::string& text);

/// Adds an option for an output directory. `names` lists the files written there.
CLI::Option* addFolderOutput(CLI::App& app, const std::string& name, std::string& path,
                             const std::string& text, std::function<Paths()> names);

/// Adds an option for a number; the help shows its default.
CLI::Option* addNumber(CLI::App& app, const std::string& flag, auto& number,
                       const std::string& text)
{
    return app.add_option(flag, number, text)->capture_default_str();
}

/// Adds an option whose value `parse` makes from its text. If `parse` returns empty, the text is refused: "TEXT is none
/// of …".
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

/// Adds an option that takes one of the names "first|second|third".
template <class Value, class FromName>
CLI::Option* addChoice(CLI::App& app, const std::string& flag, Value& value, FromName fromName,
                       const std::string& names, const std::string& text)
{
    return addParsed(app, flag, value, fromName, names, "is none of " + names, text);
}

void addRobot(CLI::App& app, std::string& robot);  ///< --robot
void addModel(CLI::App& app, std::string& model);  ///< --model
void useShippedRobot(std::string& robot);          ///< used if no --robot is given
void useShippedModel(std::string& model);          ///< used if no --model is given
void useShippedTrail(std::string& trail);          ///< used if no --trail is given

void addMethod(CLI::App& app, Settings& settings);
/// Adds an option for every method, trail included. method: a Method or an optional one.
template <class T>
void addTrailMethod(CLI::App& app, const std::string& flag, T& method, const std::string& text)
{
    addChoice(app, flag, method, methodFromName, "pa|pac|pafc|pafac|clearance|joint|local|trail",
              text);
}
void addMethods(CLI::App& app, std::vector<std::string>& methods);
/// Returns each method once, in the order given; all methods for an empty list.
std::vector<Method> methodsFrom(const std::vector<std::string>& names);

/// Adds the options that all estimating commands share. seconds: time limit of the sampling per estimate.
void addSettings(CLI::App& app, Settings& settings, double& seconds);

}  // namespace terratact
