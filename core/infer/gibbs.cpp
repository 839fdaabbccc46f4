#include "core/infer/gibbs.h"

#include <limits>
#include <memory>
#include <random>
#include <stdexcept>

#include "core/infer/truncated_normal.h"

namespace terratact {

namespace {

std::vector<int> unknownBins(const OptionalHeights& known)
{
    std::vector<int> bins;
    for (int i = 0; i < kBins; ++i)
        if (!known[static_cast<std::size_t>(i)]) bins.push_back(i);
    return bins;
}

/// One height from N(mean, sd²), the ceiling applied.
double draw(double mean, double sd, double ceiling, CeilingRule rule, std::mt19937_64& rng)
{
    const double none = std::numeric_limits<double>::infinity();
    if (rule == CeilingRule::Truncate) return drawBelow(ceiling, mean, sd, rng);
    const double free = drawBelow(none, mean, sd, rng);
    return rule == CeilingRule::Clamp ? std::min(free, ceiling) : free;
}

/// The state of all chains and the conditional of every unknown bin at this scene.
class Sampler {
public:
    Sampler(const BinModels& models, const GibbsProblem& problem)
        : models_(models), problem_(problem), bins_(unknownBins(problem.known))
    {
        for (int c = 0; c < problem.chains; ++c) {
            std::seed_seq seed{problem.seed & 0xffffffffU, problem.seed >> 32U,
                               static_cast<std::uint64_t>(c)};
            rng_.emplace_back(seed);
        }
        startRandomly();
        prepareConditionals();
    }

    const std::vector<int>& bins() const { return bins_; }
    const Heights& chain(int c) const { return state_[static_cast<std::size_t>(c)]; }

    void sweep()
    {
        for (std::size_t k = 0; k < bins_.size(); ++k) {
            gatherInputs(k);
            conditionals_[k]->predict(inputs_, mean_, variance_);
            const auto bin = static_cast<std::size_t>(bins_[k]);
            for (std::size_t c = 0; c < state_.size(); ++c) {
                const auto column = static_cast<Eigen::Index>(c);
                state_[c][bin] = draw(mean_[column], std::sqrt(variance_[column]),
                                      problem_.ceiling[bin], problem_.rule, rng_[c]);
            }
        }
    }

private:
    void startRandomly()
    {
        state_.resize(rng_.size());
        for (std::size_t c = 0; c < state_.size(); ++c) {
            for (std::size_t i = 0; i < kBins; ++i) state_[c][i] = problem_.known[i].value_or(0.0);
            for (const int i : bins_)
                state_[c][static_cast<std::size_t>(i)] =
                    draw(models_.heightMean(i), models_.heightSd(i),
                         problem_.ceiling[static_cast<std::size_t>(i)], problem_.rule, rng_[c]);
        }
    }

    /// Position of bin j among the inputs of bin i's model.
    static int inputOf(int i, int j) { return j < i ? j : j - 1; }

    void prepareConditionals()
    {
        for (const int i : bins_) {
            std::vector<int> moving;
            for (const int j : bins_)
                if (j != i) moving.push_back(inputOf(i, j));
            conditionals_.push_back(std::make_unique<SceneConditional>(
                models_.bin(i), models_.input(i, state_.front(), problem_.s), std::move(moving)));
        }
    }

    void gatherInputs(std::size_t k)
    {
        inputs_.resize(static_cast<Eigen::Index>(bins_.size()) - 1,
                       static_cast<Eigen::Index>(state_.size()));
        Eigen::Index row = 0;
        for (std::size_t other = 0; other < bins_.size(); ++other) {
            if (other == k) continue;
            const int j = bins_[other];
            for (std::size_t c = 0; c < state_.size(); ++c)
                inputs_(row, static_cast<Eigen::Index>(c)) =
                    (state_[c][static_cast<std::size_t>(j)] - models_.heightMean(j))
                    / models_.heightSd(j);
            ++row;
        }
    }

    const BinModels& models_;
    const GibbsProblem& problem_;
    std::vector<int> bins_;
    std::vector<std::mt19937_64> rng_;
    std::vector<Heights> state_;
    std::vector<std::unique_ptr<SceneConditional>> conditionals_;
    Eigen::MatrixXd inputs_;
    Eigen::VectorXd mean_, variance_;
};

void report(const Watch& watch, int done, int total)
{
    if (watch.cancelled && watch.cancelled()) throw Cancelled{};
    if (watch.progress) watch.progress(static_cast<double>(done) / total);
}

}  // namespace

GibbsDraws sampleHeights(const BinModels& models, const GibbsProblem& problem, const Watch& watch)
{
    if (problem.chains < 1 || problem.burnIn < 0 || problem.keptPerChain < 1)
        throw std::invalid_argument(
            "the sampler needs at least one chain, one kept sweep and no negative burn-in");
    GibbsDraws result{unknownBins(problem.known), {}};
    if (result.bins.empty()) return result;

    Sampler sampler(models, problem);
    result.draws.assign(result.bins.size(), Eigen::MatrixXd(problem.keptPerChain, problem.chains));
    const int total = problem.burnIn + problem.keptPerChain;
    for (int sweep = 0; sweep < total; ++sweep) {
        report(watch, sweep, total);
        sampler.sweep();
        if (sweep < problem.burnIn) continue;
        for (std::size_t k = 0; k < result.bins.size(); ++k)
            for (int c = 0; c < problem.chains; ++c)
                result.draws[k](sweep - problem.burnIn, c) =
                    sampler.chain(c)[static_cast<std::size_t>(result.bins[k])];
    }
    report(watch, total, total);
    return result;
}

}  // namespace terratact
