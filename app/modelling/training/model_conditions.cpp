#include "app/modelling/training/model_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "core/learn/model/bin_models.h"

namespace terratact {

std::string conditionsText(const ModelData& model, FeatureSet set)
{
    if (model.scannedHeights.rows() > kMaxConditionRows)
        return fmt::format("condition of the {} models: not computed for more than {} scenes\n",
                           name(set), kMaxConditionRows);
    std::string text;
    double least = std::numeric_limits<double>::infinity();
    for (int bin = 0; bin < kBins; ++bin) {
        try {
            const BinModels models(model,
                                   set);  // caches its factors, so it holds one bin at a time
            const GaussianProcess& gp = models.bin(bin);
            least = std::min(least, gp.rcond());
            if (gp.jitter() > 0.0)
                text += fmt::format(
                    "bin {:+.1f} m is singular: jitter {:.0e} of its variance, then reciprocal "
                    "condition number {:.1e}\n",
                    binCentre(bin), gp.jitter(), gp.rcond());
        } catch (const std::invalid_argument& refused) {
            text += fmt::format("bin {:+.1f} m is refused: {}\n", binCentre(bin), refused.what());
        }
    }
    if (least > 1.0) return text;  // all are refused
    return text
         + fmt::format("least reciprocal condition number of the {} models: {:.1e}\n", name(set),
                       least);
}

}  // namespace terratact
