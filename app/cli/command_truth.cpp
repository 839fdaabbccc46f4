#include "app/cli/commands.h"
#include "app/figures/truth_figure.h"
#include "app/modelling/truth/laser_truth_report.h"
#include "app/modelling/truth/truth_decisions.h"
#include "app/modelling/truth/truth_file.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/store/file_read.h"

namespace terratact {

Status findTruth(const TruthOptions& options)
{
    auto truth = laserTruth(options.find);
    if (!truth) return truth.error();
    FileGroup files;
    if (!options.review.empty()) {  // before the decisions, which are made on it
        auto review = newTruthFile(options.review, *truth, options.find.robot);
        if (!review) return review.error();
        files.add(*std::move(review));
    }
    if (!options.decisions.empty()) {
        const auto decisions = readTruthDecisions(options.decisions);
        if (!decisions) return decisions.error();
        if (Status done = applyTruthDecisions(*truth, *decisions, options.decisions); !done)
            return done;
    }
    for (const std::string& remark : truth->remarks) printText(stderr, "terratact: {}\n", remark);
    std::FILE* const messages = messagesBeside(options.out);
    printText(messages, "{}", Lines(truthReport(*truth, options.find)));
    if (!options.sheet.empty())
        if (Status done = writeTruthSheet(options.sheet, *truth, files.writer()); !done)
            return done;
    if (truth->knownHeights() == 0) {
        const Status shown = files.commit();  // review and sheet show why
        return shown ? fileError(options.find.scenes, noHeightsText(*truth)) : shown.error();
    }
    if (!options.support.empty())
        if (Status done = addText(files, options.support, truthSupportCsv(*truth)); !done)
            return done;
    if (Status done = writeTogether(files, options.out, truthScenesCsv(*truth)); !done) return done;
    printText(messages, "{} scenes with {} known heights written to {}\n", truth->scenes(),
              truth->knownHeights(), options.out);
    return Done{};
}

}  // namespace terratact
