#include "app/cli/cli_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/runtime/resources.h"
#include "app/runtime/text_output.h"
#include "core/infer/estimate/quality_preset.h"

namespace terratact {
namespace {

/// Adds the options for the cost of an estimate: a quality preset, or each number.
void addSamplingOptions(CLI::App& app, Settings& settings)
{
    const std::vector<CLI::Option*> numbers{
        addNumber(app, "--sweeps", settings.draws, "Most kept sweeps K, all chains together")
            ->check(CLI::Range(1, 10'000'000)),
        addNumber(app, "--chains", settings.chains, "Independent chains")
            ->check(CLI::Range(1, 4096)),
        addNumber(app, "--burn-in", settings.burnIn, "Sweeps thrown away per chain")
            ->check(CLI::Range(0, 1'000'000)),
        addNumber(app, "--inducing", settings.inducing,
                  "Predict through at most so many training rows (0: as trained)")
            ->check(CLI::Range(0, 20'000)),
        addChoice(app, "--precision", settings.precision, precisionFromName, "single|double",
                  "Of sampled variances (default single, through the rows that matter)")};
    const auto withNamed = [&settings](std::string_view text) -> std::optional<Settings> {
        const auto preset = qualityPresetFromName(text);
        if (!preset) return std::nullopt;
        return withPreset(settings, *preset);
    };
    auto* preset = addChoice(app, "--quality", settings, withNamed, "fast|balanced|accurate",
                             "A preset of the five above; what it costs: docs/tradeoff.md");
    for (CLI::Option* number : numbers) preset->excludes(number);
}

/// Refuses the empty name that a script gives for an unset variable.
std::string refuseNoName(const std::string& path)
{
    return path.empty() ? "the name is empty, expected the name of a file or folder" : "";
}

/// Adds an option for the name of a file or folder. value: a path or several.
template <class Value>
CLI::Option* addPath(CLI::App& app, const std::string& name, Value& value, const std::string& text)
{
    return app.add_option(name, value, text)->check(CLI::Validator(refuseNoName, ""));
}

/// Returns the input path; shells and scripts write "-" for standard input.
std::string inputPath(const std::string& given)
{
    return given == "-" ? "/dev/stdin" : given;
}

Paths given(const std::string& path)
{
    return path.empty() ? Paths{} : Paths{path};
}

/// Returns a complaint if the path is a stream, which cannot be written under a temporary name.
std::string refuseStream(const std::string& path)
{
    if (!isStandardOutput(path) && !isStream(path)) return {};
    return path + " is no file, and this output is written in several passes: name a file";
}

}  // namespace

void CommandLine::declare(const CLI::App& command, FileRole role, std::function<Paths()> paths)
{
    declarations_.push_back({&command, role, std::move(paths)});
}

CommandFiles CommandLine::files() const
{
    CommandFiles files;
    const auto append = [](Paths& into, const Paths& more) {
        into.insert(into.end(), more.begin(), more.end());
    };
    for (const Declaration& d : declarations_) {
        if (!d.command->parsed()) continue;
        const Paths paths = d.paths();
        append(d.role == FileRole::Input    ? files.inputs
               : d.role == FileRole::Update ? files.updates
                                            : files.outputs,
               paths);
        if (d.role == FileRole::Session) append(files.sessions, paths);
        if (d.role != FileRole::Input) continue;
        for (const std::string& path : paths) append(files.companions, companionsOf(path));
    }
    return files;
}

void declareFiles(CLI::App& command, FileRole role, std::function<Paths()> paths)
{
    CLI::App* root = &command;
    while (root->get_parent()) root = root->get_parent();
    dynamic_cast<CommandLine&>(*root).declare(command, role, std::move(paths));
}

CLI::Option* addInput(CLI::App& app, const std::string& name, std::string& path,
                      const std::string& text)
{
    declareFiles(app, FileRole::Input, [&path] { return given(path); });
    return addPath(app, name, path, text)->transform(inputPath, "");
}

CLI::Option* addInput(CLI::App& app, const std::string& name, Paths& paths, const std::string& text)
{
    declareFiles(app, FileRole::Input, [&paths] { return paths; });
    return addPath(app, name, paths, text)->transform(inputPath, "");
}

CLI::Option* addLog(CLI::App& app, const std::string& name, std::string& path,
                    const std::string& text)
{
    declareFiles(app, FileRole::Input, [&path] { return given(path); });
    return addPath(app, name, path, text);
}

CLI::Option* addTerrain(CLI::App& app, std::string& terrain, const std::string& text)
{
    declareFiles(app, FileRole::Input, [&terrain] {
        return terrain == "boxes" || terrain == "varied" || terrain == "hazards" ? Paths{}
                                                                                 : given(terrain);
    });
    return addPath(app, "--terrain", terrain, text)->transform(inputPath, "");
}

CLI::Option* addTextOutput(CLI::App& app, const std::string& name, std::string& path,
                           const std::string& text)
{
    declareFiles(app, FileRole::Output, [&path] { return given(path); });
    return addPath(app, name, path, text);
}

CLI::Option* addFileOutput(CLI::App& app, const std::string& name, std::string& path,
                           const std::string& text)
{
    return addTextOutput(app, name, path, text)->check(CLI::Validator(refuseStream, ""));
}

CLI::Option* addSessionOutput(CLI::App& app, const std::string& name, std::string& path,
                              const std::string& text)
{
    declareFiles(app, FileRole::Session, [&path] { return given(path); });
    return addPath(app, name, path, text)->check(CLI::Validator(refuseStream, ""));
}

CLI::Option* addFolderOutput(CLI::App& app, const std::string& name, std::string& path,
                             const std::string& text, std::function<Paths()> names)
{
    declareFiles(app, FileRole::Output, [&path, names = std::move(names)] {
        Paths files;
        for (const std::string& file : names())
            files.push_back((std::filesystem::path(path) / file).string());
        return files;
    });
    return addPath(app, name, path, text)->check(CLI::Validator(refuseStream, ""));
}

void addRobot(CLI::App& app, std::string& robot)
{
    addInput(app, "--robot", robot, "Robot file")->default_str("the shipped Absolem");
}

void addModel(CLI::App& app, std::string& model)
{
    addInput(app, "--model", model, "Model (*.ttm)")->default_str("the shipped one");
}

void useShippedRobot(std::string& robot)
{
    if (robot.empty()) robot = resourcePath("robots/absolem.toml");
}

void useShippedModel(std::string& model)
{
    if (model.empty()) model = shippedModelPath();
}

void useShippedTrail(std::string& trail)
{
    if (trail.empty()) trail = shippedTrailPath();
}

void addMethod(CLI::App& app, Settings& settings)
{
    addChoice(app, "--method", settings.method, sceneMethodFromName,
              "pa|pac|pafc|pafac|clearance|joint|local",
              fmt::format("Method (default {})", name(settings.method)));
}

void addMethods(CLI::App& app, std::vector<std::string>& methods)
{
    app.add_option("--methods", methods, "Methods to compare (default: all; trail needs --drives)")
        ->delimiter(',')
        ->check(
            CLI::IsMember({"pa", "pac", "pafc", "pafac", "clearance", "joint", "local", "trail"}));
}

std::vector<Method> methodsFrom(const std::vector<std::string>& names)
{
    std::vector<Method> methods;
    for (const std::string& text : names)
        if (const Method method = *methodFromName(text);
            std::find(methods.begin(), methods.end(), method) == methods.end())
            methods.push_back(method);
    if (methods.empty()) methods.assign(kSceneMethods.begin(), kSceneMethods.end());
    return methods;
}

void addSettings(CLI::App& app, Settings& settings, double& seconds)
{
    addChoice(app, "--ceiling", settings.ceiling, ceilingRuleFromName, "truncate|clamp|none",
              "How the robot's body bounds samples (default truncate)");
    addChoice(app, "--contacts", settings.contacts, contactRuleFromName, "isolated|any|none",
              "Which force elements fix a bin (default isolated)");
    addNumber(app, "--threshold", settings.forceThreshold, "Force of a contact [N]")
        ->check(CLI::Range(0.0, 1000.0));
    addSamplingOptions(app, settings);
    app.add_flag_callback(
        "--full", [&settings] { settings.stopEarly = false; },
        "Draw all K: chains that have converged (R-hat <= 1.01, ESS >= 400) go on, a closed form "
        "draws more than 4000");
    addNumber(app, "--seconds", seconds,
              "Most seconds of sampling per estimate (default 0: no limit); results then depend on "
              "the machine")
        ->check(CLI::Range(0.0, 86'400.0));
    addChoice(app, "--scan", settings.scan, scanOrderFromName, "forward|reverse|random",
              "Order in which a sweep visits the bins (default forward)");
    addNumber(app, "--hazard-rate", settings.hazardRate,
              fmt::format("Rate of drops and walls in 0.1 m ahead that nothing has felt (default "
                          "{}; of evaluate 0: the methods' own bands)",
                          kHazardRate))
        ->check(CLI::Range(0.0, 1.0));
    addNumber(app, "--seed", settings.seed, "Seed of the random numbers");
}

}  // namespace terratact
