#include "core/learn/model/file/model_checks.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/text.h"
#include "core/learn/data/columns.h"
#include "core/learn/data/side_features.h"
#include "core/learn/model/clearance_model.h"
#include "core/learn/model/file/model_layout.h"
#include "core/learn/model/side_training.h"

namespace terratact::model_file {
namespace {

constexpr std::size_t kMaxText = 100'000;
// range in which squares and quotients do not overflow
constexpr double kMinScale = 1e-9, kMaxScale = 1e9;
constexpr double kMaxWeight = 1e15;

void requireScale(double value, const Message& what)
{
    require(value >= kMinScale && value <= kMaxScale, [&] {
        return Message(TR_NOOP("core", "%1 is %2, expected 1e-9 to 1e9"), what, numberText(value));
    });
}

void requireRows(const ModelData& model)
{
    const Eigen::Index rows = model.heights.rows();
    require(rows >= 1 && rows <= kMaxRows && model.features.rows() == rows, [&] {
        return Message(TR_NOOP("core", "has %1 training rows, expected 1 to %2"), rows, kMaxRows);
    });
    require(model.heights.cols() == kBins && model.features.cols() == Eigen::Index{kFeatures},
            TR_NOOP("core", "its training rows have the wrong number of columns"));
    for (Eigen::Index row = 0; row < rows; ++row)
        for (Eigen::Index i = 0; i < kBins + Eigen::Index{kFeatures}; ++i) {
            const double value = i < kBins ? model.heights(row, i) : model.features(row, i - kBins);
            const Column& column = inputColumn(static_cast<std::size_t>(i));
            require(column.holds(value), [&] {
                return Message(TR_NOOP("core", "training row %1: %2"), row, column.refusal(value));
            });
        }
}

void requireSurface(const SurfaceProcess& p, std::size_t rows, Eigen::Index features,
                    const Message& what)
{
    require(std::isfinite(p.mean) && std::abs(p.mean) <= kMaxScale,
            [&] { return Message(TR_NOOP("core", "mean of %1 is out of range"), what); });
    requireScale(p.residualSd, Message(TR_NOOP("core", "residual_sd of %1"), what));
    if (p.weights.size() == 0) return;
    requireScale(p.hyper.signalSd, Message(TR_NOOP("core", "signal_sd of %1"), what));
    requireScale(p.hyper.noiseSd, Message(TR_NOOP("core", "noise_sd of %1"), what));
    require(p.hyper.lengthScale.size() == features, [&] {
        return Message(TR_NOOP("core", "%1 has the wrong number of length scales"), what);
    });
    for (const double scale : p.hyper.lengthScale)
        requireScale(scale, Message(TR_NOOP("core", "a length scale of %1"), what));
    require(
        static_cast<std::size_t>(p.weights.size())
                == std::min(rows, static_cast<std::size_t>(kInducing))
            && p.weights.allFinite(),
        [&] { return Message(TR_NOOP("core", "%1 has not one weight per inducing row"), what); });
    require(p.weights.cwiseAbs().maxCoeff() <= kMaxWeight,
            [&] { return Message(TR_NOOP("core", "a weight of %1 is out of range"), what); });
}

void requireConditional(const Hyperparameters& hyper, const Message& what)
{
    if (hyper.lengthScale.size() == 0) return;
    require(hyper.lengthScale.size() == kBins - 1 + Eigen::Index{kFeatures}, [&] {
        return Message(TR_NOOP("core", "%1 has the wrong number of length scales"), what);
    });
    for (const double scale : hyper.lengthScale)
        requireScale(scale, Message(TR_NOOP("core", "a length scale of %1"), what));
    requireScale(hyper.signalSd, Message(TR_NOOP("core", "signal_sd of %1"), what));
    requireScale(hyper.noiseSd, Message(TR_NOOP("core", "noise_sd of %1"), what));
}

void requireSurfaces(const SurfaceData& model, int bin)
{
    const ClearanceData& data = model.clearance;
    for (const bool covered : {false, true}) {
        const auto& of = covered ? data.covered : data.open;
        const Message what(TR_NOOP("core", "the surface of bin %1"), bin);
        requireSurface(of[static_cast<std::size_t>(bin)], rowsOf(model, bin, covered).size(),
                       data.featureMean.size(), what);
        requireConditional((covered ? data.conditionalCovered
                                    : data.conditionalOpen)[static_cast<std::size_t>(bin)],
                           Message(TR_NOOP("core", "the clearance conditional of bin %1"), bin));
    }
}

void requireWholeClearance(const ClearanceData& data)
{
    requireScale(data.noveltyScale, Message::verbatim("novelty_scale"));
    requireScale(data.contactSd, Message::verbatim("contact_sd"));
    require(std::abs(data.contactBias) <= 1.0, TR_NOOP("core", "contact_bias is out of range"));
}

/// Checks the rows with unknown heights, once sizes and residuals are checked.
void requireUnknown(const SurfaceData& data)
{
    if (data.unknownBins.empty()) return;
    require(std::ssize(data.unknownBins) == data.heights.rows(),
            TR_NOOP("core", "its unknown heights do not fit its training rows"));
    require(std::ranges::any_of(data.unknownBins, [](unsigned mask) { return mask != 0; }),
            TR_NOOP("core", "its table of unknown heights names none"));
    for (std::size_t u = 0; u < data.unknownBins.size(); ++u) {
        const auto row = static_cast<Eigen::Index>(u);
        require(data.unknownBins[u] < 1U << static_cast<unsigned>(kBins),
                TR_NOOP("core", "an unknown height is of a bin that does not exist"));
        for (int bin = 0; bin < kBins; ++bin)
            require(isKnown(data.unknownBins, u, bin)
                        || (data.heights(row, bin) == 0.0
                            && (data.heightSd.rows() == 0 || data.heightSd(row, bin) == 0.0)
                            && data.clearance.residuals(row, bin) == 0.0),
                    TR_NOOP("core", "it has a number for a height that is unknown"));
    }
}

void requireClearance(const SurfaceData& model, const BinSet& bins)
{
    const ClearanceData& data = model.clearance;
    const Eigen::Index rows = model.heights.rows();
    const Eigen::Index features = model.features.cols();
    require(data.featureMean.size() == features && data.featureMean.allFinite()
                && data.featureMean.cwiseAbs().maxCoeff() <= kMaxScale
                && data.featureSd.size() == features,
            TR_NOOP("core", "its clearances lack the features' standardisation"));
    for (const double sd : data.featureSd)
        requireScale(sd, TR_NOOP("core", "a standard deviation of clearances"));
    require(data.residuals.rows() == rows && data.residuals.cols() == kBins
                && data.residuals.allFinite() && data.residuals.cwiseAbs().maxCoeff() <= kMaxScale
                && data.coveredBins.size() == static_cast<std::size_t>(rows),
            TR_NOOP("core", "it has not one residual per training row and bin"));
    for (const unsigned mask : data.coveredBins)
        require(mask < 1U << static_cast<unsigned>(kBins),
                TR_NOOP("core", "a row covers a bin that does not exist"));
    requireUnknown(model);
    for (const int bin : binsOf(bins)) requireSurfaces(model, bin);
}

/// Checks that a number of a side is in its column's range and a multiple of its step.
void requireStep(double value, const Column& column, double step, Eigen::Index row)
{
    require(column.holds(value), [&] {
        return Message(TR_NOOP("core", "row %1 of two tracks: %2"), row, column.refusal(value));
    });
    require(inSteps(value, step) == value,
            TR_NOOP("core", "a value of its two tracks is not a multiple of its step"));
}

/// Returns the column of one plane that a feature of a side resembles.
const Column& columnLike(std::size_t sideFeature)
{
    if (sideFeature < kFirstSideCurrent) return featureColumns()[0];
    return featureColumns()[sideFeature < kFirstSideForce ? kFrontCurrentFeature
                                                          : kFirstForceFeature];
}

void requireSideRow(const SurfaceData& sides, Eigen::Index row)
{
    for (std::size_t d = 0; d < kSideFeatures; ++d)
        requireStep(sides.features(row, static_cast<Eigen::Index>(d)), columnLike(d),
                    sideFeatureStep(d), row);
    for (std::size_t i = 0; i < kBins; ++i)
        requireStep(sides.heights(row, static_cast<Eigen::Index>(i)), heightColumns()[i],
                    kHeightStep, row);
    const TwoTrackReadings own = readingsOf(sides.features.row(row).transpose());
    require(sideFeatures(own, Side::Right) == sides.features.row(row ^ 1).transpose(),
            TR_NOOP("core", "the two sides of a scene have other readings"));
}

void requireHeightSd(const SurfaceData& data)
{
    if (data.heightSd.rows() == 0) return;
    require(data.heightSd.rows() == data.heights.rows() && data.heightSd.cols() == kBins,
            TR_NOOP("core", "the sd of its heights do not fit its training rows"));
    for (Eigen::Index i = 0; i < kBins; ++i)
        for (const double sd : data.heightSd.col(i)) {
            const Column& column = heightSdColumns()[static_cast<std::size_t>(i)];
            require(column.holds(sd), [&] {
                return Message(TR_NOOP("core", "sd of a height: %1"), column.refusal(sd));
            });
        }
}

void requireSides(const SurfaceData& sides)
{
    const Eigen::Index rows = sides.heights.rows();
    require(rows % 2 == 0 && rows <= Eigen::Index{2} * kKeptScenes && sides.features.rows() == rows
                && sides.features.cols() == Eigen::Index{kSideFeatures}
                && sides.heights.cols() == kBins && sides.repeats == 0,
            TR_NOOP("core", "its rows of two tracks have the wrong size"));
    for (Eigen::Index row = 0; row < rows; ++row) requireSideRow(sides, row);
    requireHeightSd(sides);
    requireClearance(sides, kAllBins);
    requireWholeClearance(sides.clearance);
    require((sides.clearance.residuals.array()
             == sides.clearance.residuals.array().unaryExpr(
                 [](double residual) { return inSteps(residual, kResidualStep); }))
                .all(),
            TR_NOOP("core", "a value of its two tracks is not a multiple of its step"));
}

void requireScannedHeights(const ModelData& model)
{
    require(model.scannedHeights.rows() >= 1 && model.scannedHeights.rows() <= model.heights.rows()
                && model.scannedHeights.cols() == kBins,
            TR_NOOP("core", "its scanned rows do not fit its training rows"));
    for (Eigen::Index i = 0; i < kBins; ++i)
        for (const double height : model.scannedHeights.col(i)) {
            const Column& column = heightColumns()[static_cast<std::size_t>(i)];
            require(column.holds(height), [&] {
                return Message(TR_NOOP("core", "scanned row: %1"), column.refusal(height));
            });
        }
}

/// Checks that the conditionals learn from known heights, once sizes are checked.
void requireCompleteScans(const ModelData& model)
{
    if (model.unknownBins.empty()) return;
    const std::span first(model.unknownBins.data(),
                          static_cast<std::size_t>(model.scannedHeights.rows()));
    require(std::ranges::all_of(first, [](unsigned mask) { return mask == 0; }),
            TR_NOOP("core", "a scanned row has an unknown height"));
}

void requireBin(const Hyperparameters& bin, double logLikelihood, Eigen::Index size,
                const Message& what)
{
    require(bin.lengthScale.size() == size, [&] {
        return Message(TR_NOOP("core", "%1 has the wrong number of length scales"), what);
    });
    for (const double scale : bin.lengthScale)
        requireScale(scale, Message(TR_NOOP("core", "a length scale of %1"), what));
    requireScale(bin.signalSd, Message(TR_NOOP("core", "signal_sd of %1"), what));
    require(bin.noiseSd >= 0.0 && bin.noiseSd <= kMaxScale,
            [&] { return Message(TR_NOOP("core", "noise_sd of %1 is out of range"), what); });
    require(std::isfinite(logLikelihood),
            [&] { return Message(TR_NOOP("core", "log_likelihood of %1 is not finite"), what); });
}

void requireSet(const BinModelData& data, FeatureSet set, const BinSet& bins)
{
    const auto size = static_cast<Eigen::Index>(inputs(set));
    const Message what(TR_NOOP("core", "feature set %1"), name(set));
    require(data.set == set && data.mean.size() == size && data.sd.size() == size,
            [&] { return Message(TR_NOOP("core", "%1 has the wrong number of inputs"), what); });
    require(data.mean.allFinite() && data.mean.cwiseAbs().maxCoeff() <= kMaxScale,
            [&] { return Message(TR_NOOP("core", "a mean of %1 is out of range"), what); });
    for (const double sd : data.sd)
        requireScale(sd, Message(TR_NOOP("core", "a standard deviation of %1"), what));
    for (const int bin : binsOf(bins)) {
        const auto i = static_cast<std::size_t>(bin);
        requireBin(
            data.bins[i], data.logLikelihood[i], size - 1,
            Message(TR_NOOP("core", "feature set %1, bin %2"), name(set), heightColumns()[i].name));
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
            require(hyper.lengthScale.size() == 0,
                    TR_NOOP("core", "holds a bin that is not in its list of bins"));
        require((clearance.residuals.col(bin).array() == 0.0).all(),
                TR_NOOP("core", "holds residuals of a bin that is not in its list of bins"));
    }
    require(clearance.noveltyScale == 0.0 && clearance.contactBias == 0.0
                && clearance.contactSd == 0.0,
            TR_NOOP("core", "holds what only a whole model has"));
}

void requirePortion(const Portion& portion)
{
    require(portion.bins.any(), TR_NOOP("core", "its list of bins is empty"));
    require(portion.robotHash.size() <= kMaxText && portion.commandBeforeOut.size() <= kMaxText
                && portion.commandAfterOut.size() <= kMaxText,
            TR_NOOP("core", "its texts are too long"));
}

}  // namespace

void requireModel(const ModelData& model, const Portion* portion)
{
    const BinSet bins = portion ? portion->bins : kAllBins;
    requireRows(model);
    requireSet(model.pa, FeatureSet::Pa, bins);
    requireSet(model.paf, FeatureSet::Paf, bins);
    requireScannedHeights(model);
    requireHeightSd(model);
    requireClearance(model, bins);
    requireCompleteScans(model);
    if (portion) {
        requirePortion(*portion);
        requireNoMore(model, bins);
    } else {
        requireWholeClearance(model.clearance);
    }
    if (model.hasSides()) {
        require(!portion, TR_NOOP("core", "is a part of a model of two tracks"));
        requireSides(model.sides);
    }
    require(model.inducing >= 0 && model.inducing <= kMaxRows,
            TR_NOOP("core", "its number of inducing rows is out of range"));
    require(model.repeats >= 0 && model.repeats < model.heights.rows(),
            TR_NOOP("core", "its number of repeated rows is out of range"));
    require(model.command.size() <= kMaxText && model.dataHash.size() <= kMaxText
                && model.sidesHash.size() <= kMaxText && model.sidesCommand.size() <= kMaxText,
            TR_NOOP("core", "its texts are too long"));
}

}  // namespace terratact::model_file
