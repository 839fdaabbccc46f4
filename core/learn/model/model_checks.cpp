#include "core/learn/model/model_checks.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/learn/data/columns.h"
#include "core/learn/model/clearance_model.h"
#include "core/learn/model/model_layout.h"

namespace terratact::model_file {
namespace {

constexpr std::size_t kMaxText = 100'000;
// range in which squares and quotients do not overflow
constexpr double kMinScale = 1e-9, kMaxScale = 1e9;
constexpr double kMaxWeight = 1e15;

void requireScale(double value, const std::string& what)
{
    require(value >= kMinScale && value <= kMaxScale,
            what + " is " + numberText(value) + ", expected 1e-9 to 1e9");
}

void requireRows(const ModelData& model)
{
    const Eigen::Index rows = model.heights.rows();
    require(rows >= 1 && rows <= kMaxRows && model.features.rows() == rows,
            "has " + std::to_string(rows) + " training rows, expected 1 to "
                + std::to_string(kMaxRows));
    require(model.heights.cols() == kBins && model.features.cols() == Eigen::Index{kFeatures},
            "its training rows have the wrong number of columns");
    for (Eigen::Index row = 0; row < rows; ++row)
        for (Eigen::Index i = 0; i < kBins + Eigen::Index{kFeatures}; ++i) {
            const double value = i < kBins ? model.heights(row, i) : model.features(row, i - kBins);
            const Column& column = inputColumn(static_cast<std::size_t>(i));
            require(column.holds(value),
                    "training row " + std::to_string(row) + ": " + column.refusal(value));
        }
}

void requireSurface(const SurfaceProcess& p, std::size_t rows, const std::string& what)
{
    require(std::isfinite(p.mean) && std::abs(p.mean) <= kMaxScale,
            "mean of " + what + " is out of range");
    requireScale(p.residualSd, "residual_sd of " + what);
    if (p.weights.size() == 0) return;
    requireScale(p.hyper.signalSd, "signal_sd of " + what);
    requireScale(p.hyper.noiseSd, "noise_sd of " + what);
    require(p.hyper.lengthScale.size() == Eigen::Index{kFeatures},
            what + " has the wrong number of length scales");
    for (const double scale : p.hyper.lengthScale) requireScale(scale, "a length scale of " + what);
    require(static_cast<std::size_t>(p.weights.size())
                    == std::min(rows, static_cast<std::size_t>(kInducing))
                && p.weights.allFinite(),
            what + " has not one weight per inducing row");
    require(p.weights.cwiseAbs().maxCoeff() <= kMaxWeight,
            "a weight of " + what + " is out of range");
}

void requireConditional(const Hyperparameters& hyper, const std::string& what)
{
    if (hyper.lengthScale.size() == 0) return;
    require(hyper.lengthScale.size() == kBins - 1 + Eigen::Index{kFeatures},
            what + " has the wrong number of length scales");
    for (const double scale : hyper.lengthScale) requireScale(scale, "a length scale of " + what);
    requireScale(hyper.signalSd, "signal_sd of " + what);
    requireScale(hyper.noiseSd, "noise_sd of " + what);
}

void requireSurfaces(const ClearanceData& data, int bin)
{
    for (const bool covered : {false, true}) {
        const auto& of = covered ? data.covered : data.open;
        const std::string what = "the surface of bin " + std::to_string(bin);
        requireSurface(of[static_cast<std::size_t>(bin)],
                       rowsOf(data.coveredBins, bin, covered).size(), what);
        requireConditional((covered ? data.conditionalCovered
                                    : data.conditionalOpen)[static_cast<std::size_t>(bin)],
                           "the clearance conditional of bin " + std::to_string(bin));
    }
}

void requireWholeClearance(const ClearanceData& data)
{
    requireScale(data.noveltyScale, "novelty_scale");
    requireScale(data.contactSd, "contact_sd");
    require(std::abs(data.contactBias) <= 1.0, "contact_bias is out of range");
}

void requireClearance(const ModelData& model, const BinSet& bins)
{
    const ClearanceData& data = model.clearance;
    const Eigen::Index rows = model.heights.rows();
    const auto features = Eigen::Index{kFeatures};
    require(data.featureMean.size() == features && data.featureMean.allFinite()
                && data.featureMean.cwiseAbs().maxCoeff() <= kMaxScale
                && data.featureSd.size() == features,
            "its clearances lack the features' standardisation");
    for (const double sd : data.featureSd) requireScale(sd, "a standard deviation of clearances");
    require(data.residuals.rows() == rows && data.residuals.cols() == kBins
                && data.residuals.allFinite() && data.residuals.cwiseAbs().maxCoeff() <= kMaxScale
                && data.coveredBins.size() == static_cast<std::size_t>(rows),
            "it has not one residual per training row and bin");
    for (const unsigned mask : data.coveredBins)
        require(mask < 1U << static_cast<unsigned>(kBins),
                "a row covers a bin that does not exist");
    for (const int bin : binsOf(bins)) requireSurfaces(data, bin);
}

void requireScannedHeights(const ModelData& model)
{
    require(model.scannedHeights.rows() >= 1 && model.scannedHeights.rows() <= model.heights.rows()
                && model.scannedHeights.cols() == kBins,
            "its scanned rows do not fit its training rows");
    for (Eigen::Index i = 0; i < kBins; ++i)
        for (const double height : model.scannedHeights.col(i)) {
            const Column& column = heightColumns()[static_cast<std::size_t>(i)];
            require(column.holds(height), "scanned row: " + column.refusal(height));
        }
}

void requireBin(const Hyperparameters& bin, double logLikelihood, Eigen::Index size,
                const std::string& what)
{
    require(bin.lengthScale.size() == size, what + " has the wrong number of length scales");
    for (const double scale : bin.lengthScale) requireScale(scale, "a length scale of " + what);
    requireScale(bin.signalSd, "signal_sd of " + what);
    require(bin.noiseSd >= 0.0 && bin.noiseSd <= kMaxScale,
            "noise_sd of " + what + " is out of range");
    require(std::isfinite(logLikelihood), "log_likelihood of " + what + " is not finite");
}

void requireSet(const BinModelData& data, FeatureSet set, const BinSet& bins)
{
    const auto size = static_cast<Eigen::Index>(inputs(set));
    const std::string what = "feature set " + std::string(name(set));
    require(data.set == set && data.mean.size() == size && data.sd.size() == size,
            what + " has the wrong number of inputs");
    require(data.mean.allFinite() && data.mean.cwiseAbs().maxCoeff() <= kMaxScale,
            "a mean of " + what + " is out of range");
    for (const double sd : data.sd) requireScale(sd, "a standard deviation of " + what);
    for (const int bin : binsOf(bins)) {
        const auto i = static_cast<std::size_t>(bin);
        requireBin(data.bins[i], data.logLikelihood[i], size - 1,
                   what + ", bin " + std::string(heightColumns()[i].name));
    }
}

/// Throws Refused if the model holds what a portion leaves to others.
void requireNoMore(const ModelData& model, const BinSet& bins)
{
    const ClearanceData& clearance = model.clearance;
    for (const int bin : binsOf(~bins)) {
        const auto i = static_cast<std::size_t>(bin);
        for (const Hyperparameters& hyper :
             {model.pa.bins[i], model.paf.bins[i], clearance.conditionalOpen[i],
              clearance.conditionalCovered[i], clearance.open[i].hyper, clearance.covered[i].hyper})
            require(hyper.lengthScale.size() == 0, "holds a bin that is not in its list of bins");
        require((clearance.residuals.col(bin).array() == 0.0).all(),
                "holds residuals of a bin that is not in its list of bins");
    }
    require(clearance.noveltyScale == 0.0 && clearance.contactBias == 0.0
                && clearance.contactSd == 0.0,
            "holds what only a whole model has");
}

void requirePortion(const Portion& portion)
{
    require(portion.bins.any(), "its list of bins is empty");
    require(portion.robotHash.size() <= kMaxText && portion.commandBeforeOut.size() <= kMaxText
                && portion.commandAfterOut.size() <= kMaxText,
            "its texts are too long");
}

}  // namespace

void require(bool holds, const std::string& cause)
{
    if (!holds) throw Refused{cause};
}

void requireModel(const ModelData& model, const Portion* portion)
{
    const BinSet bins = portion ? portion->bins : kAllBins;
    requireRows(model);
    requireSet(model.pa, FeatureSet::Pa, bins);
    requireSet(model.paf, FeatureSet::Paf, bins);
    requireScannedHeights(model);
    requireClearance(model, bins);
    if (portion) {
        requirePortion(*portion);
        requireNoMore(model, bins);
    } else {
        requireWholeClearance(model.clearance);
    }
    require(model.inducing >= 0 && model.inducing <= kMaxRows,
            "its number of inducing rows is out of range");
    require(model.command.size() <= kMaxText && model.dataHash.size() <= kMaxText,
            "its texts are too long");
}

}  // namespace terratact::model_file
