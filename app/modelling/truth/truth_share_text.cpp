#include "app/modelling/truth/truth_share_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace terratact {

std::string truthShareText(std::span<const BinError> errors)
{
    std::string text;
    for (const std::string& label : labelsOf(errors)) {
        const TruthShare t = truthShare(errorsOf(label, errors));
        if (t.measured == 0) continue;
        if (text.empty())
            text = "The truth is measured: bands, coverage and CRPS count its sd, |error| contains "
                   "it.\n";
        text +=
            fmt::format("{:<12}{} of {} heights have an sd, {:.1f} mm rms: {:.0f} % of the squared "
                        "error\n",
                        label, t.measured, t.n, 1000.0 * t.sd, 100.0 * std::min(t.share, 1.0));
    }
    return text;
}

}  // namespace terratact
