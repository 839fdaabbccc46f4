#include <cblas.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <sstream>

#include "app/cli_subcommands.h"
#include "app/say.h"

namespace terratact {

namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongArguments = 2;

int realMain(int argc, char** argv)
{
    openblas_set_num_threads(1);  // our own threads run side by side, one Gaussian process each
    CLI::App app("Terrain profile by touch for tracked robots that see nothing", "terratact");
    app.set_version_flag("--version", "terratact " TERRATACT_VERSION);
    app.require_subcommand(1);
    Job job;
    addModelling(app, job, {argv + 1, argv + argc});
    addInspection(app, job);
    addBuses(app, job);
    addSessions(app, job);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::ostringstream out, complaint;  // which may quote a file's name
        const int code = app.exit(error, out, complaint);
        say("{}", Lines(out.str()));
        say(stderr, "{}", Lines(complaint.str()));
        return code == 0 ? kDone : kWrongArguments;
    }
    if (const Status done = job(); !done) {
        say(stderr, "terratact: {}\n", done.error().text);
        return kFailed;
    }
    return kDone;
}

}  // namespace

}  // namespace terratact

int main(int argc, char** argv)
{
    try {
        return terratact::realMain(argc, argv);
    } catch (const std::exception& error) {
        terratact::say(stderr, "terratact: {}\n", error.what());
        return 1;
    }
}
