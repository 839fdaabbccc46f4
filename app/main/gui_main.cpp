// The operator's console: parses the command line and opens a window.
#include <cblas.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "app/console/open_console.h"
#include "app/imports/open_import.h"
#include "app/imports/open_truth.h"
#include "app/review/open_recorded.h"
#include "app/runtime/big_blocks.h"
#include "app/runtime/file_guard.h"
#include "app/runtime/parse_arguments.h"
#include "app/runtime/print_text.h"
#include "app/runtime/standard_streams.h"
#include "app/runtime/uncaught_exception.h"
#include "app/shell/open_file.h"
#include "app/start/console_setup.h"
#include "core/base/memory_limit.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

// [bytes] minimum besides the libraries; without a limit it uses 750 MB
constexpr std::size_t kWindowMemory = 700'000'000;

int failed(const std::string& why)
{
    printText(stderr, "terratact-console: {}\n", why);
    return kFailed;
}

Result<int> openWindow(Application& application, const ConsoleOptions& options)
{
    if (options.replay.empty()) return openConsole(application, options);
    const FileKind kind = kindOfFile(QString::fromStdString(options.replay));
    if (kind == FileKind::Session) return openReview(application, options);
    if (kind == FileKind::Scenes) return openScenes(application, options);
    if (kind == FileKind::Truth) return openTruth(application, options);
    if (kind == FileKind::Recording && !options.isPicture())
        return openImport(application, options);
    if (options.isPicture()) {
        const auto content = readFile(options.replay, 1);
        if (!content && content.error().code != 0) return content.error();
        return Error{options.replay + ": is no session, of which a picture could be saved"};
    }
    return openConsole(application, options);
}

int refused(Application& application, const ConsoleOptions& options, const Error& why)
{
    const int code = failed(why.text);
    if (options.errorsInWindow && !options.isPicture()
        && application.start(inForce(preferencesFor(options).preferences, options), false))
        printRefusal(options.replay, why.message);
    return code;
}

int run(int& argc, char** argv)
{
    reportFileSizeLimit();
    CLI::App app("The operator's console of Terratact: feel the terrain that cannot be seen");
    ConsoleOptions options;
    declareOptions(app, options);
    if (const auto status = parseArguments(app, argc, argv)) return *status;
    if (memoryIsLimited())
        if (const std::string missing = memoryMissing("the window", kWindowMemory);
            !missing.empty())
            return failed(missing);
    if (const Status s = checkCommandFiles(filesOf(options)); !s) return failed(s.error().text);
    Application application(argc, argv);
    const auto ended = openWindow(application, options);
    return ended ? *ended : refused(application, options, ended.error());
}

}  // namespace
}  // namespace terratact

int main(int argc, char** argv)
{
    terratact::holdStandardStreams();
    terratact::printFailureOnTerminate("terratact-console");
    terratact::giveBackBigBlocks();
    openblas_set_num_threads(1);  // the estimator has its own threads
    try {
        return terratact::run(argc, argv);
    } catch (const std::exception& error) {
        return terratact::failed(terratact::describeFailure(error));
    }
}
