#include "core/learn/model_hash.h"

#include <bit>
#include <string_view>

#include "core/learn/model_layout.h"
#include "core/learn/sha256.h"

namespace terratact::model_file {
namespace {

/// Bytes that do not depend on the machine: numbers as 8 bytes, least first, texts after their length.
class Canonical {
public:
    void add(std::uint64_t value)
    {
        for (int i = 0; i < 8; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xFFU);
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }  // -0 becomes 0
    void add(std::string_view text)
    {
        add(std::uint64_t{text.size()});
        bytes_ += text;
    }
    /// Row by row.
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
        for (std::size_t i = 0; i < kBins; ++i) {
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
    void add(const ClearanceData& data)
    {
        add(Eigen::MatrixXd(data.featureMean));
        add(Eigen::MatrixXd(data.featureSd));
        for (const auto* processes : {&data.open, &data.covered})
            for (const SurfaceProcess& process : *processes) add(process);
        for (const auto* conditionals : {&data.conditionalOpen, &data.conditionalCovered})
            for (const Hyperparameters& hyper : *conditionals) add(hyper);
        for (const unsigned mask : data.coveredBins) add(std::uint64_t{mask});
        add(data.residuals);
        add(data.noveltyScale);
        add(data.contactBias);
        add(data.contactSd);
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

}  // namespace

std::string hashOf(const ModelData& model)
{
    Canonical canonical;
    canonical.add(std::string_view("Terratact model 2"));
    canonical.add(model.pa);
    canonical.add(model.paf);
    canonical.add(model.heights);
    canonical.add(model.features);
    canonical.add(model.scannedHeights);
    canonical.add(model.clearance);
    canonical.add(model.command);
    canonical.add(model.seed);
    canonical.add(model.dataHash);
    return sha256Hex(canonical.bytes());
}

}  // namespace terratact::model_file
