#pragma once

#include <algorithm>
#include <limits>
#include <random>
#include <string>

#include "core/learn/model/clearance_model.h"
#include "core/learn/model/model.h"

namespace terratact {

/// Adds random clearances: bins 0 to 8 are covered in every row; in every third row bin 8 is open.
template <class Within>
void addClearance(ModelData& model, Within within)
{
    const auto random = [&within](Eigen::Index size, double least, double most) {
        Eigen::VectorXd v(size);
        for (double& x : v) x = within(least, most);
        return v;
    };
    ClearanceData& data = model.clearance;
    const Eigen::Index rows = model.heights.rows();
    data.featureMean = random(11, -1.0, 1.0);
    data.featureSd = random(11, 0.1, 1.0);
    data.noveltyScale = within(0.5, 2.0);
    data.contactBias = within(-0.01, 0.01);
    data.contactSd = within(0.01, 0.1);
    for (Eigen::Index u = 0; u < rows; ++u)
        data.coveredBins.push_back(u % 3 == 0 ? 0x0FFU : 0x1FFU);
    data.residuals.resize(rows, kBins);
    for (double& x : data.residuals.reshaped()) x = within(-1.0, 1.0);
    for (int bin = 0; bin < kBins; ++bin)
        for (const bool covered : {false, true}) {
            auto& process = (covered ? data.covered : data.open)[static_cast<std::size_t>(bin)];
            process.mean = within(-5.0, 1.0);
            process.residualSd = within(0.01, 1.0);
            const auto inducing = inducingRows(rowsOf(data.coveredBins, {}, bin, covered)).size();
            if (inducing == 0) continue;
            process.hyper = {random(11, 0.1, 9.0), within(0.1, 1.0), within(0.01, 0.1)};
            process.weights = random(static_cast<Eigen::Index>(inducing), -2.0, 2.0);
        }
}

/// Returns a model of random numbers with `rows` training rows.
inline ModelData randomModel(Eigen::Index rows, unsigned seed = 1)
{
    std::mt19937_64 rng(seed);
    const auto within = [&rng](double least, double most) {
        return std::uniform_real_distribution(least, most)(rng);
    };
    const auto vector = [&within](Eigen::Index size, double least, double most) {
        Eigen::VectorXd v(size);
        for (double& x : v) x = within(least, most);
        return v;
    };
    ModelData model;
    model.command = "terratact train --data scenes.csv --out model.ttm";
    model.seed = std::numeric_limits<std::uint64_t>::max();
    model.dataHash = std::string(64, 'a');
    model.heights.resize(rows, kBins);
    model.features.resize(rows, 11);
    for (double& x : model.heights.reshaped()) x = within(-0.5, 0.5);
    for (double& x : model.features.reshaped()) x = within(0.0, 3.0);
    model.scannedHeights = model.heights.topRows(std::max<Eigen::Index>(rows / 2, 1));
    addClearance(model, within);
    for (BinModelData* data : {&model.pa, &model.paf}) {
        data->set = data == &model.pa ? FeatureSet::Pa : FeatureSet::Paf;
        const Eigen::Index size = data == &model.pa ? 14 : 22;
        data->mean = vector(size, -1.0, 1.0);
        data->sd = vector(size, 0.1, 1.0);
        for (std::size_t i = 0; i < kBins; ++i) {
            data->bins[i] = {vector(size - 1, 0.1, 9.0), within(0.1, 1.0), within(0.0, 0.1)};
            data->logLikelihood[i] = within(-1000.0, 1000.0);
        }
    }
    return model;
}

inline bool same(const BinModelData& a, const BinModelData& b)
{
    bool bins = a.logLikelihood == b.logLikelihood;
    for (std::size_t i = 0; i < kBins; ++i)
        bins = bins && a.bins[i].lengthScale == b.bins[i].lengthScale
            && a.bins[i].signalSd == b.bins[i].signalSd && a.bins[i].noiseSd == b.bins[i].noiseSd;
    return bins && a.set == b.set && a.mean == b.mean && a.sd == b.sd;
}

inline bool same(const SurfaceProcess& a, const SurfaceProcess& b)
{
    if (a.mean != b.mean || a.residualSd != b.residualSd || a.weights.size() != b.weights.size())
        return false;
    return a.weights.size() == 0
        || (a.weights == b.weights && a.hyper.lengthScale == b.hyper.lengthScale
            && a.hyper.signalSd == b.hyper.signalSd && a.hyper.noiseSd == b.hyper.noiseSd);
}

inline bool same(const ClearanceData& a, const ClearanceData& b)
{
    bool processes = true;
    for (std::size_t i = 0; i < kBins; ++i)
        processes = processes && same(a.open[i], b.open[i]) && same(a.covered[i], b.covered[i]);
    return processes && a.featureMean == b.featureMean && a.featureSd == b.featureSd
        && a.coveredBins == b.coveredBins && a.residuals == b.residuals
        && a.noveltyScale == b.noveltyScale && a.contactBias == b.contactBias
        && a.contactSd == b.contactSd;
}

inline bool same(const ModelData& a, const ModelData& b)
{
    return a.scannedHeights == b.scannedHeights && same(a.clearance, b.clearance)
        && a.heights == b.heights && a.features == b.features && same(a.pa, b.pa)
        && same(a.paf, b.paf) && a.command == b.command && a.seed == b.seed
        && a.dataHash == b.dataHash && a.inducing == b.inducing && a.repeats == b.repeats
        && a.unknownBins == b.unknownBins;
}

}  // namespace terratact
