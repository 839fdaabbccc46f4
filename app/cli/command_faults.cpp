#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/modelling/trials/fault_trials.h"
#include "app/runtime/print_text.h"
#include "core/sim/fault_matrix.h"

namespace terratact {
namespace {

/// Returns the median as text; "never" if fewer than half of the drives have a value.
std::string medianText(std::vector<double> values, std::size_t drives, const char* format)
{
    const auto median = medianOfDrives(std::move(values), drives);
    return median ? fmt::format(fmt::runtime(format), *median) : "never";
}

void printFault(const TriedFault& fault, const FaultCounts& row)
{
    const ErrorStatistics all = statistics(row.errors), trusted = statistics(row.trustedErrors);
    const std::string left =
        row.trustedErrors.empty()
            ? fmt::format("{:>8}{:>7}", "-", "-")
            : fmt::format("{:>8.1f}{:>7.1f}", 1000.0 * trusted.mean, 100.0 * trusted.coverage);
    printText("{:<38}{:>8.1f}{:>7.1f}{:>9.1f}{:>8.1f}{:>8.1f}{:>8.1f}{:>9}{:>8}{}\n", fault.words,
              1000.0 * all.mean, 100.0 * all.coverage, sharePercent(row.suspects, row.scenes),
              sharePercent(row.contradicting, row.scenes), sharePercent(row.doubted, row.scenes),
              sharePercent(row.seconds.size(), row.drives),
              medianText(row.seconds, row.drives, "{:.1f}"),
              medianText(row.scenesUntil, row.drives, "{:.0f}"), left);
    std::fflush(stdout);
}

void printHead(const FaultTrial& trial, std::size_t drives, std::size_t leftOut)
{
    printText("{} drives over {}{}, a scene every {:.2f} m", drives, trial.grounds.terrain,
              trial.comesBack ? " and back" : "", trial.spacing);
    if (trial.comesBack)
        printText("; {} that came back less than {:.0f} m are left out", leftOut, kMinWayBack);
    printText("\n");
    printText("{:<38}{:>8}{:>7}{:>9}{:>8}{:>8}{:>8}{:>9}{:>8}{:>8}{:>7}\n", "", "mean mm", "in 80",
              "suspect", "contra", "doubt", "drives", "after s", "scenes", "left mm", "in 80");
}

/// Prints the matrix of fault kinds and sensors; a letter refers to a reason printed below it.
void printMatrix(const RobotModel& robot, const WatchedDrives& drives)
{
    std::vector<std::string_view> reasons;
    printText("{:<20}", "drives [%]");
    for (const std::string_view kind : matrixKinds()) printText("{:>14}", kind);
    const std::size_t columns = matrixKinds().size();
    std::size_t column = 0;
    for (const MatrixCell& cell : faultMatrix()) {
        if (column++ % columns == 0) printText("\n{:<20}", cell.sensor);
        std::string mark;
        if (!cell.reason.empty()) {
            const auto known = std::find(reasons.begin(), reasons.end(), cell.reason);
            mark = fmt::format(" {}", static_cast<char>('a' + (known - reasons.begin())));
            if (known == reasons.end()) reasons.push_back(cell.reason);
        }
        printText("{:>12.0f}{:<2}", noticedPercent(cell.fault, robot, drives), mark);
    }
    printText("\n\nWhy one is not noticed in every drive:\n");
    for (std::size_t k = 0; k < reasons.size(); ++k)
        printText("  {}: {}\n", static_cast<char>('a' + k), reasons[k]);
}

}  // namespace

Status judgeFaults(const FaultsOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    const auto driven = driveForFaults((*bundle)->robot, options.trial);
    if (!driven) return driven.error();
    if (options.matrix) {
        printMatrix((*bundle)->robot, driven->drives);
        return Done{};
    }
    printHead(options.trial, driven->drives.size(), driven->leftOut);
    FaultCounts sound;
    std::size_t harmful = 0, flagged = 0;
    std::string missed;
    for (const TriedFault& fault : triedFaults()) {
        FaultCounts row = tryFault(fault, options.trial, **bundle, driven->drives);
        printFault(fault, row);
        if (fault.fault.empty()) {
            sound = std::move(row);
            continue;
        }
        const bool isHarmful = harms(row, sound);
        harmful += isHarmful ? 1 : 0;
        flagged += isHarmful && isFlagged(row) ? 1 : 0;
        if (!isFlagged(row))
            missed += fmt::format("  {}{}: {}\n", fault.words, isHarmful ? "" : " (harmless)",
                                  fault.limit.empty() ? "not in every drive" : fault.limit);
    }
    printText("\n{} of {} faults that harm are noticed; not noticed:\n{}", flagged, harmful,
              Lines(missed));
    return Done{};
}

}  // namespace terratact
