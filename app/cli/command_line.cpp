#include "app/cli/command_line.h"

#include <cblas.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <system_error>

#include "app/cli/cli_options.h"
#include "app/cli/cli_subcommands.h"
#include "app/runtime/parse_arguments.h"
#include "app/runtime/print_text.h"
#include "app/runtime/standard_streams.h"
#include "app/runtime/uncaught_exception.h"
#include "core/base/memory_limit.h"
#include "core/store/unfinished_files.h"

namespace terratact {

namespace {

constexpr int kDone = 0;

/// Leaves nothing half-written behind Ctrl+C and the like. A command that is asked to ignore a
/// signal, as nohup does, still ignores it.
void removeUnfinishedOnSignals()
{
    const auto onSignal = [](int signal) {
        removeUnfinished();
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    };
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, onSignal) == SIG_IGN) std::signal(signal, SIG_IGN);
}

int realMain(int argc, char** argv)
{
    removeUnfinishedOnSignals();
    reportFileSizeLimit();
    openblas_set_num_threads(1);  // our own threads run in parallel, one Gaussian process each
    CommandLine app("Terrain profile by touch for tracked robots that see nothing", "terratact");
    app.set_version_flag("--version", "terratact " TERRATACT_VERSION);
    app.require_subcommand(1);
    Job job;
    addModelling(app, job, {argv + 1, argv + argc});
    addInspection(app, job);
    addBuses(app, job);
    addTruth(app, job);
    addSessions(app, job);
    if (const auto status = parseArguments(app, argc, argv)) return *status;
    Status done = checkCommandFiles(app.files());
    if (done) done = job();
    if (done) return kDone;
    printText(stderr, "terratact: {}\n", done.error().text);
    return kFailed;
}

/// Returns `code`, or kFailed if standard output did not accept all text, for example on a full disk.
int afterPrinting(int code)
{
    errno = 0;
    std::cout.flush();
    const bool whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
    if (whole) return code;
    printText(stderr, "terratact: the standard output cannot be written{}{}\n",
              errno != 0 ? ": " : "", errno != 0 ? std::generic_category().message(errno) : "");
    return code == kDone ? kFailed : code;
}

}  // namespace

int runCommandLine(int argc, char** argv)
{
    holdStandardStreams();
    printFailureOnTerminate("terratact");
    try {
        return afterPrinting(realMain(argc, argv));
    } catch (const std::exception& error) {
        printText(stderr, "terratact: {}\n", describeFailure(error));
        return kFailed;
    }
}

}  // namespace terratact
