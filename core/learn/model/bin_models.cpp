#include "core/learn/model/bin_models.h"

#include <algorithm>
#include <stdexcept>

namespace terratact {

Eigen::MatrixXd standardised(const Eigen::MatrixXd& raw, const Eigen::VectorXd& mean,
                             const Eigen::VectorXd& sd)
{
    return (raw.rowwise() - mean.transpose()).array().rowwise() / sd.transpose().array();
}

Eigen::MatrixXd rawInputs(const ModelData& model, FeatureSet set)
{
    const auto f = static_cast<Eigen::Index>(featureNames(set).size());
    const Eigen::Index rows = model.scannedHeights.rows();
    Eigen::MatrixXd raw(rows, kBins + f);
    raw << model.scannedHeights, model.features.topLeftCorner(rows, f);
    return raw;
}

Eigen::MatrixXd withoutBin(const Eigen::MatrixXd& standardisedInputs, int bin)
{
    Eigen::MatrixXd X(standardisedInputs.rows(), standardisedInputs.cols() - 1);
    X << standardisedInputs.leftCols(bin),
        standardisedInputs.rightCols(standardisedInputs.cols() - bin - 1);
    return X;
}

BinModels::BinModels(const ModelData& model, FeatureSet set)
    : data_(set == FeatureSet::Pa ? model.pa : model.paf),
      standardised_(standardised(rawInputs(model, set), data_.mean, data_.sd)),
      heights_(model.scannedHeights),
      truthSd_(model.heightSd.topRows(std::min(heights_.rows(), model.heightSd.rows()))),
      inducing_(model.inducing)
{
}

const GaussianProcess& BinModels::bin(int i, int inducing, const Poll& poll) const
{
    if (i < 0 || i >= kBins) throw std::invalid_argument("bins are numbered 0 to 10");
    if (inducing < 0) throw std::invalid_argument("the number of inducing rows must be 0 or more");
    const int rows = rowsToInduce(inducing, inducing_, standardised_.rows());
    return lazy_[static_cast<std::size_t>(i)].get(
        rows,
        [&] {
            const double mean = data_.mean[i];
            const Eigen::VectorXd variance = truthSd_.rows() > 0
                                               ? Eigen::VectorXd(truthSd_.col(i).array().square())
                                               : Eigen::VectorXd();
            auto gp = GaussianProcess::sparse(
                withoutBin(standardised_, i), heights_.col(i).array() - mean, rows,
                data_.bins[static_cast<std::size_t>(i)], mean, poll, variance);
            factorised_ |= 1UL << static_cast<unsigned>(i);
            return gp;
        },
        poll);
}

Eigen::VectorXd BinModels::input(int i, const Heights& h, const Eigen::VectorXd& s) const
{
    Eigen::VectorXd raw(kBins + s.size());
    raw << Eigen::Map<const Eigen::VectorXd>(h.data(), kBins), s;
    if (raw.size() != data_.mean.size())
        throw std::invalid_argument("s does not fit the model's feature set");
    const Eigen::VectorXd x = (raw - data_.mean).cwiseQuotient(data_.sd);
    Eigen::VectorXd without(x.size() - 1);
    without << x.head(i), x.tail(x.size() - i - 1);
    return without;
}

}  // namespace terratact
