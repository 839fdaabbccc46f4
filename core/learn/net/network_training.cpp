#include "core/learn/net/network_training.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

#include "core/base/random_unit.h"
#include "core/learn/kernels/blas.h"
#include "core/learn/kernels/blas_size.h"

namespace terratact {
namespace {

constexpr double kRise = 0.3;  // share of the steps
constexpr double kStart = 25.0, kEnd = 250'000.0;
constexpr float kMomentum = 0.9F, kSquares = 0.999F, kSmall = 1e-8F;

/// C = op(A) op(B); op transposes.
void product(const Eigen::MatrixXf& A, CBLAS_TRANSPOSE a, const Eigen::MatrixXf& B,
             CBLAS_TRANSPOSE b, Eigen::MatrixXf& C)
{
    const Eigen::Index rows = a == CblasNoTrans ? A.rows() : A.cols();
    const Eigen::Index inner = a == CblasNoTrans ? A.cols() : A.rows();
    const Eigen::Index columns = b == CblasNoTrans ? B.cols() : B.rows();
    C.resize(rows, columns);
    blas(cblas_sgemm, CblasColMajor, a, b, blasSize(rows), blasSize(columns), blasSize(inner), 1.0F,
         A.data(), blasSize(A.rows()), B.data(), blasSize(B.rows()), 0.0F, C.data(),
         blasSize(rows));
}

void shuffle(std::vector<Eigen::Index>& order, std::mt19937_64& rng)
{
    for (std::size_t k = order.size(); k > 1; --k)
        std::swap(order[k - 1],
                  order[static_cast<std::size_t>(randomUnit(rng) * static_cast<double>(k))]);
}

Network firstWeights(Eigen::Index inputs, Eigen::Index outputs, const NetworkOptions& options,
                     std::mt19937_64& rng)
{
    std::vector<Eigen::Index> widths = options.hidden;
    widths.push_back(outputs);
    Network network;
    for (const Eigen::Index width : widths) {
        const double bound = 1.0 / std::sqrt(static_cast<double>(inputs));
        const auto draw = [&] { return static_cast<float>(bound * (2.0 * randomUnit(rng) - 1.0)); };
        network.layers.push_back({Eigen::MatrixXf::NullaryExpr(width, inputs, draw),
                                  Eigen::VectorXf::NullaryExpr(width, draw)});
        inputs = width;
    }
    return network;
}

double stepSize(long step, long steps, double peak)
{
    const double rise = kRise * static_cast<double>(steps);
    const auto now = static_cast<double>(step);
    const auto along = [](double from, double to, double share) {
        return to + (from - to) * 0.5 * (1.0 + std::cos(std::numbers::pi * share));
    };
    if (now < rise) return along(peak / kStart, peak, now / rise);
    return along(peak, peak / kEnd, (now - rise) / (static_cast<double>(steps) - rise));
}

/// First and second moments of the gradient of some parameters.
class Moments {
public:
    Moments(Eigen::Index rows, Eigen::Index columns)
        : mean_(Eigen::ArrayXXf::Zero(rows, columns)), square_(mean_)
    {
    }

    /// Moves the parameters by one step of AdamW; t counts from 1.
    template <class Parameters, class Gradient>
    void step(Parameters& parameters, const Gradient& gradient, long t, float rate, float decay)
    {
        mean_ = kMomentum * mean_ + (1.0F - kMomentum) * gradient.array();
        square_ = kSquares * square_ + (1.0F - kSquares) * gradient.array().square();
        const auto times = static_cast<float>(t);
        const float meanScale = 1.0F / (1.0F - std::pow(kMomentum, times));
        const float squareScale = 1.0F / (1.0F - std::pow(kSquares, times));
        parameters.array() *= 1.0F - rate * decay;
        parameters.array() -=
            rate * (meanScale * mean_) / ((squareScale * square_).sqrt() + kSmall);
    }

private:
    Eigen::ArrayXXf mean_, square_;
};

/// A network while it learns.
class Learner {
public:
    Learner(Network network, const NetworkOptions& options)
        : network_(std::move(network)), options_(options)
    {
        for (const NetworkLayer& layer : network_.layers) {
            weights_.emplace_back(layer.weight.rows(), layer.weight.cols());
            biases_.emplace_back(layer.bias.size(), 1);
        }
    }

    /// One step on a batch. weights: as those of trainNetwork().
    void learn(const Eigen::MatrixXf& inputs, const Eigen::MatrixXf& targets,
               const Eigen::MatrixXf& weights, long t, double rate)
    {
        forward(inputs);
        const auto h = static_cast<float>(options_.huber);
        const auto count = static_cast<float>(targets.size());
        Eigen::MatrixXf gradient =
            ((activation_.back() - targets).array() / h).max(-1.0F).min(1.0F).matrix() / count;
        if (weights.size() > 0) gradient.array() *= weights.array();
        for (std::size_t k = network_.layers.size(); k > 0; --k)
            gradient = backward(k - 1, gradient, t, static_cast<float>(rate));
    }

    Network take() { return std::move(network_); }

private:
    void forward(const Eigen::MatrixXf& inputs)
    {
        activation_.resize(network_.layers.size() + 1);
        sum_.resize(network_.layers.size());
        activation_.front() = inputs;
        for (std::size_t k = 0; k < network_.layers.size(); ++k) {
            const NetworkLayer& layer = network_.layers[k];
            product(layer.weight, CblasNoTrans, activation_[k], CblasNoTrans, sum_[k]);
            sum_[k].colwise() += layer.bias;
            if (k + 1 < network_.layers.size())
                activation_[k + 1] = silu(sum_[k]);
            else
                activation_[k + 1] = sum_[k];
        }
    }

    /// Moves a layer along its gradient, and returns that of the layer before.
    Eigen::MatrixXf backward(std::size_t k, const Eigen::MatrixXf& gradient, long t, float rate)
    {
        NetworkLayer& layer = network_.layers[k];
        const auto decay = static_cast<float>(options_.weightDecay);
        Eigen::MatrixXf before, ofWeight;
        if (k > 0) {
            product(layer.weight, CblasTrans, gradient, CblasNoTrans, before);
            const Eigen::ArrayXXf gate = 1.0F / (1.0F + (-sum_[k - 1].array()).exp());
            before.array() *= gate * (1.0F + sum_[k - 1].array() * (1.0F - gate));
        }
        product(gradient, CblasNoTrans, activation_[k], CblasTrans, ofWeight);
        weights_[k].step(layer.weight, ofWeight, t, rate, decay);
        biases_[k].step(layer.bias, Eigen::VectorXf(gradient.rowwise().sum()), t, rate, decay);
        return before;
    }

    Network network_;
    const NetworkOptions& options_;
    std::vector<Moments> weights_, biases_;
    std::vector<Eigen::MatrixXf> activation_, sum_;
};

void requireTrainable(const Eigen::MatrixXf& inputs, const Eigen::MatrixXf& targets,
                      const Eigen::MatrixXf& weights, const NetworkOptions& options)
{
    const bool isWeighted = weights.size() > 0;
    if (isWeighted
        && (weights.rows() != targets.rows() || weights.cols() != targets.cols()
            || !(weights.array() >= 0.0F).all() || !(weights.array() <= 1.0F).all()))
        throw std::invalid_argument("a network's weights are one number of 0 to 1 per target");
    if (options.epochs < 1 || options.batch < 1 || !(options.peakRate > 0.0)
        || !(options.weightDecay >= 0.0) || !(options.huber > 0.0)
        || std::ranges::any_of(options.hidden, [](Eigen::Index width) { return width < 1; }))
        throw std::invalid_argument("an option of a network's training is out of range");
    if (inputs.cols() != targets.cols() || inputs.cols() < options.batch || inputs.rows() < 1
        || targets.rows() < 1)
        throw std::invalid_argument("a network learns from at least one batch of rows");
    if (!inputs.allFinite() || !targets.allFinite())
        throw std::invalid_argument("a network learns from finite numbers");
}

}  // namespace

Network trainNetwork(const Eigen::MatrixXf& inputs, const Eigen::MatrixXf& targets,
                     const NetworkOptions& options, const Poll& poll,
                     const Eigen::MatrixXf& weights)
{
    requireTrainable(inputs, targets, weights, options);
    std::mt19937_64 rng(options.seed);
    Learner learner(firstWeights(inputs.rows(), targets.rows(), options, rng), options);
    std::vector<Eigen::Index> order(static_cast<std::size_t>(inputs.cols()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const Eigen::Index batches = inputs.cols() / options.batch;
    const long steps = static_cast<long>(batches) * options.epochs;
    long t = 0;
    for (int epoch = 0; epoch < options.epochs; ++epoch) {
        shuffle(order, rng);
        for (Eigen::Index b = 0; b < batches; ++b) {
            callPoll(poll);
            const Eigen::Map<const Eigen::Array<Eigen::Index, Eigen::Dynamic, 1>> rows(
                order.data() + b * options.batch, options.batch);
            ++t;
            Eigen::MatrixXf weighted;
            if (weights.size() > 0) weighted = weights(Eigen::all, rows);
            learner.learn(inputs(Eigen::all, rows), targets(Eigen::all, rows), weighted, t,
                          stepSize(t, steps, options.peakRate));
        }
    }
    return learner.take();
}

}  // namespace terratact
