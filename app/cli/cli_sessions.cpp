#include <cmath>
#include <memory>

#include "app/cli/cli_options.h"
#include "app/cli/cli_subcommands.h"
#include "app/cli/session/session_commands.h"
#include "app/link/log_help.h"
#include "app/runtime/resources.h"
#include "core/base/text.h"

namespace terratact {
namespace {

using Files = std::vector<std::string>;

void addSessionFiles(CLI::App& app, Files& files)
{
    addInput(app, "files", files, "Sessions (*.tts)")->required();
}

/// Adds a subcommand whose only arguments are sessions.
void addOfFiles(CLI::App& session, Job& job, const std::string& name, const std::string& text,
                Status (*run)(const Files&))
{
    auto* c = session.add_subcommand(name, text);
    const auto files = std::make_shared<Files>();
    addSessionFiles(*c, *files);
    c->callback([files, run, &job] { job = [files, run] { return run(*files); }; });
}

void addSessionList(CLI::App& session, Job& job)
{
    auto* c = session.add_subcommand("list", "One line for each recording of a folder");
    const auto folder = std::make_shared<std::string>();
    addInput(*c, "folder", *folder, "Folder of sessions; without it that of this user's console");
    c->callback([folder, &job] { job = [folder] { return listSessions(*folder); }; });
}

void addSessionRecover(CLI::App& session, Job& job)
{
    auto* c = session.add_subcommand("recover", "Close sessions whose program died; of damaged "
                                                "ones, save what is whole");
    const auto o = std::make_shared<RecoverOptions>();
    addSessionFiles(*c, o->files);
    addSessionOutput(*c, "--out", o->out,
                     "Session to write where the file is damaged or cannot be written; without it "
                     "NAME-recovered.tts beside it");
    c->callback([o, &job] { job = [o] { return recoverSessions(*o); }; });
}

void addSessionVerify(CLI::App& session, Job& job)
{
    auto* c = session.add_subcommand("verify", "Check every hash; exit code 0: all is as it was "
                                               "recorded");
    const auto o = std::make_shared<VerifyOptions>();
    addSessionFiles(*c, o->files);
    c->add_option("--link", o->link,
                  "Last link of the chain as it was noted elsewhere: shows that nothing was "
                  "cut off");
    c->callback([o, &job] { job = [o] { return verifySessions(*o); }; });
}

/// Adds an option for an end of a time range.
void addMoment(CLI::App& app, const std::string& name, double& seconds)
{
    const auto refuseNan = [](const std::string& text) {
        const auto value = numberFrom(text);
        return value && std::isnan(*value) ? text + " is no time" : std::string();
    };
    app.add_option(name, seconds, "Seconds since the session's start")
        ->check(CLI::Validator(refuseNan, ""));
}

/// Refuses DBC files where the rows hold no signals. exportSession() refuses them for a log of frames.
void refuseUnusedDbc(const SessionExportOptions& o)
{
    const auto format = o.format ? o.format : exportFormatOf(o.out);
    const auto what = o.selection.what;
    const bool isUnused = (format == ExportFormat::Csv && what != ExportKind::Signals)
                       || (format == ExportFormat::Mcap
                           && (what == ExportKind::Estimates || what == ExportKind::Events));
    if (isUnused && !o.dbc.empty())
        throw CLI::ValidationError("--dbc", "these rows hold no signals: choose --what signals");
}

void addSessionExport(CLI::App& session, Job& job)
{
    auto* c = session.add_subcommand("export", "Write frames, signals, estimates or events for "
                                               "other programs");
    const auto o = std::make_shared<SessionExportOptions>();
    addInput(*c, "file", o->file, "Session (*.tts)")->required();
    addTextOutput(*c, "--out", o->out, "File to write")->required();
    addChoice(*c, "--format", o->format, exportFormatFromName, "candump|asc|csv|mcap",
              "Of the file; without it by the ending .log, .asc, .csv or "
              ".mcap");
    addChoice(*c, "--what", o->selection.what, exportKindFromName,
              "frames|signals|estimates|events", "Which rows (CSV: frames if not said; MCAP: all)");
    addMoment(*c, "--from", o->selection.from);
    addMoment(*c, "--to", o->selection.to);
    addInput(*c, "--dbc", o->dbc,
             "DBC file: adds the signals of frames that are not the protocol's to signals "
             "(CSV) or everything (MCAP); may be repeated")
        ->allow_extra_args(false);
    c->callback([o, &job] {
        refuseUnusedDbc(*o);
        if (o->selection.from > o->selection.to)
            throw CLI::ValidationError("--from", "must not be later than --to");
        job = [o] { return exportSession(*o); };
    });
}

void addSessionScenes(CLI::App& session, Job& job)
{
    auto* c =
        session.add_subcommand("scenes", "Write captured scenes as CSV for train, reconstruct "
                                         "and evaluate");
    const auto o = std::make_shared<SessionScenesOptions>();
    addSessionFiles(*c, o->files);
    addTextOutput(*c, "--out", o->out, "Scenes CSV to write")->required();
    auto* const measured =
        c->add_flag("--measured", o->measured,
                    "Where no truth is known, the heights that contacts and the arm measured");
    c->add_flag("--tracks", o->tracks,
                "Readings and heights of left and right, for --tracks of those commands");
    c->add_flag("--drives", o->drives,
                "Drives CSV: the way between the scenes, too, for truth, and train and evaluate "
                "--drives")
        ->excludes(measured);
    c->callback([o, &job] { job = [o] { return exportScenes(*o); }; });
}

void addSessionStrip(CLI::App& session, Job& job)
{
    auto* c = session.add_subcommand("strip", "Write the ground felt along the drive as a profile, "
                                              "a point cloud or a picture");
    const auto o = std::make_shared<SessionStripOptions>();
    addInput(*c, "file", o->file, "Session (*.tts)")->required();
    addTextOutput(
        *c, "--out", o->out,
        "CSV profile, PLY point cloud, or picture (.png, .svg, .pdf, .html), by the ending")
        ->required();
    c->add_option("--section", o->section, "This stretch without a break alone, by its number")
        ->check(CLI::Range(1, 1'000'000));
    c->callback([o, &job] { job = [o] { return exportStrip(*o); }; });
}

void addSessionReport(CLI::App& session, Job& job)
{
    auto* c =
        session.add_subcommand("report", "One page about a scene, or the mission report of the "
                                         "whole session");
    const auto o = std::make_shared<SessionReportOptions>();
    addInput(*c, "file", o->file, "Session (*.tts)")->required();
    auto* scene = c->add_option("--scene", o->scene, "Its number; without it the last")
                      ->check(CLI::Range(1, 1'000'000'000));
    c->add_flag(
         "--mission", o->mission,
         "The whole session: facts, felt ground, decisions, alarms, settings, hashes; PDF or "
         "HTML")
        ->excludes(scene);
    addInput(*c, "--dbc", o->dbc,
             "DBC file: adds the newest values of frames that are not the protocol's; may be "
             "repeated")
        ->allow_extra_args(false);
    addFileOutput(*c, "--out", o->out, "PDF, SVG, PNG or HTML to write, by the ending")->required();
    c->callback([o, &job] { job = [o] { return reportSession(*o); }; });
}

void addSessionMerge(CLI::App& session, Job& job)
{
    auto* c = session.add_subcommand("merge", "Put sessions of one drive together");
    const auto o = std::make_shared<SessionMergeOptions>();
    addSessionFiles(*c, o->files);
    addSessionOutput(*c, "--out", o->out, "Session to write (*.tts)")->required();
    c->callback([o, &job] { job = [o] { return mergeSessions(*o); }; });
}

void addSessionWhatIf(CLI::App& session, Job& job)
{
    auto* c = session.add_subcommand("what-if", "Compute recorded estimates again, as they were or "
                                                "with other settings");
    const auto o = std::make_shared<WhatIfOptions>();
    addInput(*c, "files", o->files, "Sessions (*.tts), or folders of them")->required();
    c->add_option("--estimate", o->rerun.estimate, "This one alone, by its number")
        ->check(CLI::Range(1, 1'000'000'000));
    addTrailMethod(*c, "--method", o->rerun.changes.method, "Another method");
    addChoice(*c, "--quality", o->rerun.changes.preset, qualityPresetFromName,
              "fast|balanced|accurate",
              "Draws, chains, burn-in, precision and inducing rows of a "
              "preset");
    c->add_option("--threshold", o->rerun.changes.threshold, "Another force of a contact [N]")
        ->check(CLI::Range(0.0, 1000.0));
    c->add_option("--seed", o->rerun.changes.seed, "Another seed of the random numbers");
    addInput(*c, "--model", o->rerun.model,
             "Another model (*.ttm), or where the session's is, if it is "
             "not the shipped one");
    declareFiles(*c, FileRole::Input, [o] {
        Paths read = shippedModelPaths();
        if (!o->rerun.model.empty()) read.push_back(o->rerun.model);
        for (const std::string& model : Paths(read)) read.push_back(trailPathBeside(model));
        return read;
    });
    addTextOutput(*c, "--out", o->out, "CSV to write, a row for each bin");
    c->callback([o, &job] {
        o->rerun.shippedModels = shippedModelPaths();
        job = [o] { return whatIf(*o); };
    });
}

void addSessionImport(CLI::App& session, Job& job)
{
    auto* c = session.add_subcommand("import", "Make a session of a log of CAN frames");
    const auto o = std::make_shared<SessionImportOptions>();
    addLog(*c, "log", o->log, kLogHelp)->required();
    addSessionOutput(*c, "--out", o->out, "Session to write (*.tts)")->required();
    c->add_option("--interface", o->interface, "Of a log that holds several");
    addRobot(*c, o->robot);
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        job = [o] { return importLog(*o); };
    });
}

void addImport(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand("import", "Make a session of a recording of another program: "
                                           "docs/import.md");
    const auto o = std::make_shared<ImportOptions>();
    addInput(*c, "file", o->file,
             "Recording: MCAP, bag of ROS 1 (.bag) or ROS 2 (.db3), or CSV of a time series")
        ->required();
    addInput(*c, "--mapping", o->mapping,
             "Mapping file (TOML): which field is which sensor; --probe proposes one");
    addRobot(*c, o->robot);
    auto* out = addSessionOutput(*c, "--out", o->out, "Session to write (*.tts)");
    addTextOutput(*c, "--scenes", o->scenes,
                  "Scenes CSV to write: where the robot stood still with flippers pressed")
        ->needs(out);
    auto* probe = c->add_flag("--probe", o->probe,
                              "List topics, fields, rates and ranges, and propose a mapping");
    auto* check = c->add_flag("--check", o->check,
                              "Name gaps, clock offsets, doubtful units, stuck and saturated "
                              "values; exit code 0: none");
    probe->excludes(out)->excludes(check);
    check->excludes(out);
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        if (!o->probe && o->mapping.empty())
            throw CLI::RequiredError("--mapping (--probe proposes one)");
        if (!o->probe && !o->check && o->out.empty()) throw CLI::RequiredError("--out");
        job = [o] { return importOrProbe(*o); };
    });
}

}  // namespace

void addSessions(CLI::App& app, Job& job)
{
    auto* session = app.add_subcommand("session", "Look at recorded sessions, check and export "
                                                  "them: docs/sessions.md");
    session->require_subcommand(1);
    addOfFiles(*session, job, "info", "What is in them, and whether it holds", showSessions);
    addSessionList(*session, job);
    addSessionVerify(*session, job);
    addSessionRecover(*session, job);
    addSessionExport(*session, job);
    addSessionScenes(*session, job);
    addSessionStrip(*session, job);
    addSessionReport(*session, job);
    addSessionMerge(*session, job);
    addSessionWhatIf(*session, job);
    addSessionImport(*session, job);
    addImport(app, job);
}

}  // namespace terratact
