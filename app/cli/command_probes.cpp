#include <fmt/core.h>

#include <string>

#include "app/cli/commands.h"
#include "app/runtime/print_text.h"
#include "core/eval/probe_sd.h"
#include "core/learn/data/probe_file.h"
#include "core/store/file_read.h"

namespace terratact {

namespace {

constexpr double kMinSd = 0.5e-4;  ///< [m] resolution of the robot file's four decimals

/// Returns the reason that the readings give no sd; empty: they give one.
std::string whyNoSd(const ProbeAccuracy& accuracy)
{
    const auto alike = [](const char* what) {
        return fmt::format("{} the same, or nearly (sd below {:.2f} mm): are they rounded, or "
                           "copied? The sd is unknown",
                           what, 1e3 * kMinSd);
    };
    if (accuracy.repeated.freedom > 0 && accuracy.repeated.sd < kMinSd)
        return alike("all readings of a place are");
    if (accuracy.fromTruth.n > 1 && accuracy.fromTruth.sd < kMinSd)
        return alike("every reading differs from its truth by");
    if (accuracy.repeated.freedom == 0 && accuracy.fromTruth.n < 2)
        return "no place is read twice, and fewer than two readings have a truth: the sd is "
               "unknown";
    return {};
}

}  // namespace

Status showProbes(const std::string& path)
{
    const auto readings = readProbeReadings(path);
    if (!readings) return readings.error();
    const ProbeAccuracy accuracy = probeAccuracy(*readings);
    printText("{} readings of {} places\n", accuracy.readings, accuracy.places);
    if (const SdEstimate& s = accuracy.repeated; s.freedom > 0)
        printText("repeating a place    sd {:.1f} mm [{:.1f}, {:.1f}]\n", 1e3 * s.sd, 1e3 * s.low,
                  1e3 * s.high);
    if (const ResidualStatistics& s = accuracy.fromTruth; s.n > 1)
        printText("truth less reading   mean {:+.1f} mm, sd {:.1f} mm, robust sd {:.1f} mm; "
                  "{} readings\n",
                  1e3 * s.mean, 1e3 * s.sd, 1e3 * s.robustSd, s.n);
    if (const std::string why = whyNoSd(accuracy); !why.empty()) return fileError(path, why);
    printText("\nfor the robot file:\n[arm]\nreading_sd_m = {:.4f}\n", readingSd(accuracy));
    return Done{};
}

}  // namespace terratact
