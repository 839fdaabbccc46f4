#include "core/learn/model/file/model_hash.h"

#include <string_view>
#include <vector>

#include "core/learn/model/file/model_layout.h"
#include "core/store/canonical_bytes.h"
#include "core/store/sha256.h"

namespace terratact::model_file {
namespace {

/// Bytes of a model for hashing; with a portion, only those of its bins.
class Canonical : public CanonicalBytes {
public:
    using CanonicalBytes::add;

    explicit Canonical(const BinSet& bins) : bins_(binsOf(bins)) {}
    /// Adds the matrix row by row.
    void add(const Eigen::MatrixXd& matrix)
    {
        add(static_cast<std::uint64_t>(matrix.rows()));
        add(static_cast<std::uint64_t>(matrix.cols()));
        for (Eigen::Index row = 0; row < matrix.rows(); ++row)
            for (Eigen::Index i = 0; i < matrix.cols(); ++i) add(matrix(row, i));
    }
    void add(const BinModelData& data)
    {
        add(name(data.set));
        for (std::size_t i = 0; i < inputs(data.set); ++i) {
            add(inputColumn(i).name);
            add(inputColumn(i).unit);
        }
        add(Eigen::MatrixXd(data.mean));
        add(Eigen::MatrixXd(data.sd));
        for (const int bin : bins_) {
            const auto i = static_cast<std::size_t>(bin);
            add(Eigen::MatrixXd(data.bins[i].lengthScale));
            add(data.bins[i].signalSd);
            add(data.bins[i].noiseSd);
            add(data.logLikelihood[i]);
        }
    }
    void add(const SurfaceProcess& process)
    {
        add(process.mean);
        add(process.residualSd);
        add(Eigen::MatrixXd(process.weights));
        if (process.weights.size() > 0) add(process.hyper);
    }
    void add(const Hyperparameters& hyper)
    {
        add(Eigen::MatrixXd(hyper.lengthScale));
        if (hyper.lengthScale.size() == 0) return;
        add(hyper.signalSd);
        add(hyper.noiseSd);
    }
    void addMasks(const std::vector<unsigned>& masks)
    {
        for (const unsigned mask : masks) add(std::uint64_t{mask});
    }
    void add(const ClearanceData& data)
    {
        add(Eigen::MatrixXd(data.featureMean));
        add(Eigen::MatrixXd(data.featureSd));
        for (const auto* processes : {&data.open, &data.covered})
            for (const int bin : bins_) add((*processes)[static_cast<std::size_t>(bin)]);
        for (const auto* conditionals : {&data.conditionalOpen, &data.conditionalCovered})
            for (const int bin : bins_) add((*conditionals)[static_cast<std::size_t>(bin)]);
        addMasks(data.coveredBins);
        add(data.residuals);
        add(data.noveltyScale);
        add(data.contactBias);
        add(data.contactSd);
    }

private:
    std::vector<int> bins_;
};

}  // namespace

std::string hashOf(const ModelData& model, const Portion* portion)
{
    Canonical canonical(portion ? portion->bins : kAllBins);
    canonical.add(std::string_view("Terratact model 2"));
    if (portion) {
        canonical.add(std::string_view(text(portion->bins)));
        canonical.add(portion->robotHash);
        canonical.add(portion->commandBeforeOut);
        canonical.add(portion->commandAfterOut);
    }
    canonical.add(model.pa);
    canonical.add(model.paf);
    canonical.add(model.heights);
    canonical.add(model.features);
    canonical.add(model.scannedHeights);
    canonical.add(model.clearance);
    canonical.add(model.command);
    canonical.add(model.seed);
    canonical.add(model.dataHash);
    if (model.inducing > 0) canonical.add(static_cast<std::uint64_t>(model.inducing));
    if (model.repeats > 0) {
        canonical.add(std::string_view("repeated rows"));
        canonical.add(static_cast<std::uint64_t>(model.repeats));
    }
    if (model.heightSd.rows() > 0) {
        canonical.add(std::string_view("sd of heights"));
        canonical.add(model.heightSd);
    }
    if (!model.unknownBins.empty()) {
        canonical.add(std::string_view("unknown heights"));
        canonical.addMasks(model.unknownBins);
    }
    if (model.hasSides()) {
        canonical.add(std::string_view("two tracks"));
        canonical.add(model.sides.features);
        canonical.add(model.sides.heights);
        canonical.add(model.sides.clearance);
        canonical.add(model.sidesHash);
        canonical.add(model.sidesCommand);
        if (model.sides.heightSd.rows() > 0) canonical.add(model.sides.heightSd);
        if (!model.sides.unknownBins.empty()) {
            canonical.add(std::string_view("unknown heights of two tracks"));
            canonical.addMasks(model.sides.unknownBins);
        }
    }
    return sha256Hex(canonical.bytes());
}

}  // namespace terratact::model_file
