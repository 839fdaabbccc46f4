#include <fmt/core.h>

#include <string>

#include "app/cli/commands.h"
#include "app/runtime/print_text.h"
#include "core/eval/contact_sd.h"
#include "core/learn/data/scene_file.h"

namespace terratact {

namespace {

void printRow(const std::string& where, const ResidualStatistics& s)
{
    printText("{:>8} {:>6}", where, s.n);
    if (s.n > 1)
        printText(" {:>+9.1f} {:>7.1f} {:>9.1f}", 1e3 * s.mean, 1e3 * s.sd, 1e3 * s.robustSd);
    printText("\n");
}

void printTable(ContactRule rule, const ContactSummary& summary)
{
    printText("\ncontact rule: {}\n{:>8} {:>6} {:>9} {:>7} {:>9}\n", name(rule), "bin [m]", "n",
              "mean [mm]", "sd [mm]", "robust sd");
    for (int i = 0; i < kBins; ++i) {
        const ResidualStatistics& s = summary.bin[static_cast<std::size_t>(i)];
        if (s.n > 0) printRow(fmt::format("{:+.1f}", binCentre(i)), s);
    }
    printRow("all", summary.all);
}

}  // namespace

Status showContacts(const ContactsOptions& options)
{
    const auto robot = readRobotModel(options.robot);
    if (!robot) return robot.error();
    const auto file = readScenes(options.data);
    if (!file) return file.error();
    for (const Message& notice : file->notices)
        printText(stderr, "terratact: {}\n", notice.english());
    const auto summaryBy = [&](ContactRule rule) {
        return summariseContacts(contactResiduals(*robot, file->scenes, options.threshold, rule));
    };
    const ContactSummary any = summaryBy(ContactRule::Any);
    if (any.all.n == 0)
        return Error{options.data + ": no contact in a bin whose height is known", 0};
    printText(
        "true height of a bin less the height of its contact; {} scenes, contacts above {} N\n",
        file->scenes.size(), options.threshold);
    printTable(ContactRule::Isolated, summaryBy(ContactRule::Isolated));
    printTable(ContactRule::Any, any);
    return Done{};
}

}  // namespace terratact
