#include "app/imports/open_truth.h"

#include <utility>

#include "app/imports/truth_window.h"
#include "app/start/console_setup.h"
#include "app/start/until_closed.h"

namespace terratact {

Result<int> openTruth(Application& application, const ConsoleOptions& options)
{
    auto file = TruthFile::open(options.replay);
    if (!file) return file.error();
    const LoadedPreferences loaded = preferencesFor(options);
    if (const Status ready =
            application.start(inForce(loaded.preferences, options), options.isPicture());
        !ready)
        return ready.error();
    TruthWindow window(*std::move(file));
    return untilClosed(window, options, [&window] { return !window.isFittingFont(); });
}

}  // namespace terratact
