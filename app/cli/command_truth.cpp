#include "app/cli/commands.h"
#include "app/figures/truth_figure.h"
#include "app/modelling/laser_truth_report.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/store/file_read.h"

namespace terratact {

Status findTruth(const TruthOptions& options)
{
    const auto truth = laserTruth(options.find);
    if (!truth) return truth.error();
    for (const std::string& remark : truth->remarks) printText(stderr, "terratact: {}\n", remark);
    std::FILE* const messages = messagesBeside(options.out);
    printText(messages, "{}", Lines(truthReport(*truth, options.find)));
    if (!options.sheet.empty())
        if (Status done = writeTruthSheet(options.sheet, *truth); !done) return done;
    if (truth->knownHeights() == 0)
        return fileError(
            options.find.scenes,
            "no bin has a known height: look at the alignment above, at --max-sd, and at --sheet");
    if (!options.support.empty())
        if (Status done = writeText(options.support, truthSupportCsv(*truth)); !done) return done;
    if (Status done = writeText(options.out, truthScenesCsv(*truth)); !done) return done;
    printText(messages, "{} scenes with {} known heights written to {}\n", truth->scenes(),
              truth->knownHeights(), options.out);
    return Done{};
}

}  // namespace terratact
