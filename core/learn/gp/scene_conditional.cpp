#include "core/learn/gp/scene_conditional.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "core/learn/kernels/kernel_poll.h"

namespace terratact {

namespace {

template <class T>
void makeRoom(AlignedArray<T>& array, std::size_t size)
{
    if (array.size() < size) array = AlignedArray<T>(size);
}

/// Returns the number of entries of one block of covariances.
std::size_t blockSize(Eigen::Index rows)
{
    return entriesOf(paddedRows(static_cast<int>(rows)), kGroup);
}

/// Clears the rows beyond U, which another process may have written.
template <class T>
void clearPadding(T* block, Eigen::Index rows)
{
    std::fill(block + entriesOf(rows, kGroup), block + blockSize(rows), T{});
}

template <class T>
void copyColumns(const T* from, T* to, int columns, Eigen::Index rows)
{
    for (Eigen::Index u = 0; u < rows; ++u)
        std::copy_n(from + u * kGroup, columns, to + u * kGroup);
}

PredictionRoom::Covariances<double>& covariancesIn(PredictionRoom& room, double)
{
    return room.full;
}

PredictionRoom::Covariances<float>& covariancesIn(PredictionRoom& room, float)
{
    return room.single;
}

void compute(const CovarianceKernels& kernels, const CovarianceInput& in, const double* z,
             double* K, double* mean)
{
    kernels.covariances(in, z, K, mean);
}

void compute(const CovarianceKernels& kernels, const CovarianceInput& in, const double* z, float* K,
             double* mean)
{
    kernels.covariancesSingle(in, z, K, mean);
}

void square(const CovarianceKernels& kernels, const double* panels, const double* K, int U,
            int groups, double* out, const Poll& poll)
{
    kernels.sumsOfSquares(panels, K, U, groups, out, kernelPoll(poll));
}

void square(const CovarianceKernels& kernels, const float* panels, const float* K, int U,
            int groups, double* out, const Poll& poll)
{
    kernels.sumsOfSquaresSingle(panels, K, U, groups, out, kernelPoll(poll));
}

}  // namespace

SceneConditional::SceneConditional(const GaussianProcess& gp, const Eigen::VectorXd& x,
                                   std::vector<int> moving, Precision precision, const Poll& poll,
                                   const CovarianceKernels& kernels)
    : gp_(gp), kernels_(kernels), moving_(std::move(moving)),
      X_(static_cast<std::size_t>(gp.rows()) * moving_.size()), perLength_(moving_.size()),
      logWeight_(static_cast<std::size_t>(gp.rows())), alpha_(static_cast<std::size_t>(gp.rows()))
{
    if (x.size() != gp.inputs() || !x.allFinite())
        throw std::invalid_argument(
            fmt::format("a prediction needs {} finite inputs", gp.inputs()));
    if (gp.usable(precision, poll) == Precision::Single) {
        const InverseFactor::Single& single = gp.inverse_->single(poll);
        panelsSingle_ = single.panels.data();
        kept_ = single.kept;
        addRows(x, single.order);
    } else {
        panels_ = gp.inverse_->panels(poll);
        kept_ = static_cast<int>(gp.rows());
        std::vector<int> all(static_cast<std::size_t>(kept_));
        std::iota(all.begin(), all.end(), 0);
        addRows(x, all);
    }
}

/// Copies the process's rows, in that order.
void SceneConditional::addRows(const Eigen::VectorXd& x, const std::vector<int>& order)
{
    const Eigen::VectorXd& scale = gp_.hyper_.lengthScale;
    Eigen::VectorXd distance2 = Eigen::VectorXd::Zero(gp_.rows());
    for (int d = 0; d < gp_.inputs(); ++d)
        if (std::find(moving_.begin(), moving_.end(), d) == moving_.end())
            distance2.array() += ((gp_.X_.col(d).array() - x[d]) / scale[d]).square();
    const auto m = static_cast<Eigen::Index>(moving_.size());
    for (Eigen::Index j = 0; j < m; ++j)
        perLength_.data()[j] = 1.0 / scale[moving_[static_cast<std::size_t>(j)]];
    Eigen::Index place = 0;
    for (const int u : order) {
        logWeight_.data()[place] = -0.5 * distance2[u];
        alpha_.data()[place] = gp_.alpha_[u];
        for (Eigen::Index j = 0; j < m; ++j)
            X_.data()[place * m + j] = gp_.X_(u, moving_[static_cast<std::size_t>(j)]);
        ++place;
    }
}

bool SceneConditional::sharesFactorWith(const SceneConditional& other) const
{
    return &kernels_ == &other.kernels_ && panels_ == other.panels_
        && panelsSingle_ == other.panelsSingle_;
}

/// Copies columns first … first + count − 1 of the inputs: m × 8.
void SceneConditional::copyInputs(const Eigen::MatrixXd& inputs, Eigen::Index first, int count,
                                  double* z) const
{
    for (std::size_t j = 0; j < moving_.size(); ++j)
        for (int c = 0; c < count; ++c)
            z[j * kGroup + static_cast<std::size_t>(c)] =
                inputs(static_cast<Eigen::Index>(j), first + c);
}

/// Writes the scene's covariances and means into the joint columns from `first` on. The columns
/// behind them in their last block are undefined until the next scene writes them.
template <class T>
void SceneConditional::covariances(const Eigen::MatrixXd& inputs, int first, PredictionRoom& room,
                                   const Poll& poll) const
{
    const CovarianceInput in{X_.data(),
                             perLength_.data(),
                             logWeight_.data(),
                             alpha_.data(),
                             static_cast<int>(gp_.rows()),
                             kept_,
                             static_cast<int>(moving_.size()),
                             gp_.hyper_.signalSd * gp_.hyper_.signalSd};
    auto& K = covariancesIn(room, T{});
    const auto n = static_cast<int>(inputs.cols());
    for (int c = 0, count = 0; c < n; c += count) {
        callPoll(poll);
        const int column = first + c;
        const int lane = column % kGroup;
        count = std::min(kGroup - lane, n - c);
        copyInputs(inputs, c, count, room.z.data());
        T* block = K.all.data() + entriesOf(column / kGroup, 1) * blockSize(kept_);
        if (lane == 0) {
            clearPadding(block, kept_);
            compute(kernels_, in, room.z.data(), block, room.means.data() + column);
        } else {
            compute(kernels_, in, room.z.data(), K.block.data(), room.blockMeans.data());
            copyColumns(K.block.data(), block + lane, count, kept_);
            std::copy_n(room.blockMeans.data(), count, room.means.data() + column);
        }
    }
}

/// asked: scenes of one process.
template <class T>
void SceneConditional::pass(std::span<const ScenePrediction> asked, PredictionRoom& room,
                            const Poll& poll)
{
    const SceneConditional& any = *asked.front().conditional;
    int columns = 0;
    std::size_t inputs = 1;
    for (const ScenePrediction& one : asked) {
        columns += static_cast<int>(one.inputs->cols());
        inputs = std::max(inputs, one.conditional->moving_.size());
    }
    const int groups = groupsOf(columns);
    auto& K = covariancesIn(room, T{});
    makeRoom(K.all, entriesOf(groups, 1) * blockSize(any.kept_));
    makeRoom(K.block, blockSize(any.kept_));
    makeRoom(room.z, inputs * kGroup);
    makeRoom(room.means, entriesOf(groups, kGroup));
    makeRoom(room.squares, entriesOf(groups, kGroup));
    int first = 0;
    for (const ScenePrediction& one : asked) {
        one.conditional->covariances<T>(*one.inputs, first, room, poll);
        first += static_cast<int>(one.inputs->cols());
    }
    const T* panels = nullptr;
    if constexpr (sizeof(T) == sizeof(float))
        panels = any.panelsSingle_;
    else
        panels = any.panels_;
    square(any.kernels_, panels, K.all.data(), any.kept_, groups, room.squares.data(), poll);
    first = 0;
    for (const ScenePrediction& one : asked) {
        one.conditional->finish(room, first, *one.mean, *one.variance);
        first += static_cast<int>(one.inputs->cols());
    }
}

/// mean, variance: sized to the scene's columns.
void SceneConditional::finish(const PredictionRoom& room, int first, Eigen::VectorXd& mean,
                              Eigen::VectorXd& variance) const
{
    const double noise2 = gp_.hyper_.noiseSd * gp_.hyper_.noiseSd;
    const double prior = gp_.hyper_.signalSd * gp_.hyper_.signalSd + noise2;
    // Rounding must not go below the noise, nor to 0 without noise.
    const double least = std::max(noise2, kMinVariance * prior);
    const Eigen::Index n = mean.size();
    mean = Eigen::Map<const Eigen::ArrayXd>(room.means.data() + first, n) + gp_.outputMean_;
    variance = (prior - Eigen::Map<const Eigen::ArrayXd>(room.squares.data() + first, n))
                   .max(least)
                   .matrix();
}

void SceneConditional::predict(const Eigen::MatrixXd& inputs, Eigen::VectorXd& mean,
                               Eigen::VectorXd& variance) const
{
    PredictionRoom room;
    const ScenePrediction one{this, &inputs, &mean, &variance};
    predictTogether({&one, 1}, room);
}

void predictTogether(std::span<const ScenePrediction> asked, PredictionRoom& room, const Poll& poll)
{
    std::vector<ScenePrediction> left(asked.begin(), asked.end());
    for (const ScenePrediction& one : left) {
        if (!one.inputs->allFinite())
            throw std::invalid_argument("a prediction needs finite inputs");
        one.mean->resize(one.inputs->cols());
        one.variance->resize(one.inputs->cols());
    }
    for (auto from = left.begin(); from != left.end();) {
        const SceneConditional& any = *from->conditional;
        const auto to = std::stable_partition(from, left.end(), [&any](const auto& one) {
            return one.conditional->sharesFactorWith(any);
        });
        if (any.panelsSingle_)
            SceneConditional::pass<float>({from, to}, room, poll);
        else
            SceneConditional::pass<double>({from, to}, room, poll);
        from = to;
    }
}

}  // namespace terratact
