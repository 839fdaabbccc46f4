#include "core/infer/gibbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

#include "core/infer/bin_conditionals.h"
#include "core/infer/truncated_normal.h"
#include "core/learn/covariance_kernels.h"

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

/// The positions in I that a sweep visits one after the other; the same for all chains.
class SweepOrder {
public:
    SweepOrder(ScanOrder scan, std::uint64_t seed) : scan_(scan)
    {
        std::seed_seq words{seed & 0xffffffffU, seed >> 32U, std::uint64_t{0}, std::uint64_t{1}};
        rng_.seed(words);  // four words: no chain's generator has this seed
    }

    const std::vector<std::size_t>& next(std::size_t count)
    {
        if (order_.size() != count) {
            order_.resize(count);
            std::iota(order_.begin(), order_.end(), std::size_t{0});
            if (scan_ == ScanOrder::Reverse) std::reverse(order_.begin(), order_.end());
        }
        if (scan_ == ScanOrder::Random) shuffle();
        return order_;
    }

private:
    /// Fisher and Yates; the remainder's bias is below 1e-18.  The same with every standard library.
    void shuffle()
    {
        for (std::size_t left = order_.size(); left > 1; --left)
            std::swap(order_[left - 1], order_[rng_() % left]);
    }

    ScanOrder scan_;
    std::mt19937_64 rng_;
    std::vector<std::size_t> order_;
};

/// Speaks to the watch for all threads.
class Reporter {
public:
    Reporter(const Watch& watch, int total) : watch_(watch), total_(total) {}

    void stopIfCancelled()
    {
        const std::scoped_lock lock(mutex_);
        terratact::stopIfCancelled(watch_);
    }

    /// Before each sweep and after the last one.
    void step()
    {
        const std::scoped_lock lock(mutex_);
        if (watch_.progress) watch_.progress(static_cast<double>(done_) / total_);
        ++done_;
    }

private:
    const Watch& watch_;
    int total_;
    std::mutex mutex_;
    int done_ = 0;
};

/// The state of some of the chains.
class Sampler {
public:
    /// first, count: among the problem's chains.
    Sampler(const Conditionals& conditionals, const GibbsProblem& problem, int first, int count)
        : problem_(problem), bins_(unknownBins(problem.known)), order_(problem.scan, problem.seed)
    {
        for (int c = 0; c < count; ++c) {
            std::seed_seq seed{problem.seed & 0xffffffffU, problem.seed >> 32U,
                               static_cast<std::uint64_t>(problem.firstChain + first + c)};
            rng_.emplace_back(seed);
        }
        startRandomly(conditionals);
        Heights known{};
        for (std::size_t i = 0; i < kBins; ++i) known[i] = problem.known[i].value_or(0.0);
        conditionals_ = conditionals.at(known, bins_);
    }

    /// |I| × chains.
    const Eigen::MatrixXd& states() const { return states_; }

    void sweep(Reporter& reporter)
    {
        for (const std::size_t k : order_.next(bins_.size())) {
            reporter.stopIfCancelled();
            conditionals_->predict(k, states_, mean_, variance_);
            for (std::size_t c = 0; c < rng_.size(); ++c) {
                const auto column = static_cast<Eigen::Index>(c);
                drawState(k, c, mean_[column], std::sqrt(variance_[column]));
            }
        }
    }

private:
    void startRandomly(const Conditionals& conditionals)
    {
        states_.resize(static_cast<Eigen::Index>(bins_.size()),
                       static_cast<Eigen::Index>(rng_.size()));
        for (std::size_t c = 0; c < rng_.size(); ++c)
            for (std::size_t k = 0; k < bins_.size(); ++k) {
                const StartDraw start = conditionals.start(bins_[k]);
                drawState(k, c, start.mean, start.sd);
            }
    }

    void drawState(std::size_t k, std::size_t c, double mean, double sd)
    {
        const double ceiling = problem_.ceiling[static_cast<std::size_t>(bins_[k])];
        states_(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(c)) =
            draw(mean, sd, ceiling, problem_.rule, rng_[c]);
    }

    const GibbsProblem& problem_;
    std::vector<int> bins_;
    SweepOrder order_;
    std::vector<std::mt19937_64> rng_;
    Eigen::MatrixXd states_;
    std::unique_ptr<SceneConditionals> conditionals_;
    Eigen::VectorXd mean_, variance_;
};

/// Runs some chains to the end; their columns of the draws start at `first`.
void runChains(Sampler& sampler, const GibbsProblem& problem, int first, Reporter& reporter,
               GibbsDraws& result)
{
    const Eigen::Index count = sampler.states().cols();
    for (int sweep = -problem.burnIn; sweep < problem.keptPerChain; ++sweep) {
        reporter.step();
        sampler.sweep(reporter);
        if (sweep < 0) continue;
        for (std::size_t k = 0; k < result.bins.size(); ++k)
            result.draws[k].row(sweep).segment(first, count) =
                sampler.states().row(static_cast<Eigen::Index>(k));
    }
}

/// Chains that one thread runs: full groups of columns, two where that still makes several parts.
int chainsPerPart(const GibbsProblem& problem, const Watch& watch)
{
    if (!watch.sideBySide) return problem.chains;
    return problem.chains > 4 * kGroup ? 2 * kGroup : kGroup;
}

}  // namespace

void checkSettings(const Settings& settings)
{
    if (settings.draws < 1 || settings.chains < 1 || settings.burnIn < 0)
        throw std::invalid_argument(
            "an estimate needs at least one draw, one chain and no negative burn-in");
    if (settings.inducing < 0)
        throw std::invalid_argument("the number of inducing rows must be 0 or more");
    if (!(settings.contactSd > 0.0) || !(settings.forceThreshold >= 0.0))
        throw std::invalid_argument(
            "the contacts' sd must be positive and the force threshold 0 or more");
}

GibbsProblem problemFor(const Settings& settings)
{
    GibbsProblem problem;
    problem.scan = settings.scan;
    problem.chains = settings.chains;
    problem.burnIn = settings.burnIn;
    problem.precision = settings.precision;
    problem.keptPerChain = (settings.draws + settings.chains - 1) / settings.chains;
    problem.inducing = settings.inducing;
    problem.seed = settings.seed;
    return problem;
}

GibbsDraws sampleStates(const Conditionals& conditionals, const GibbsProblem& problem,
                        const Watch& watch)
{
    if (problem.chains < 1 || problem.firstChain < 0 || problem.burnIn < 0
        || problem.keptPerChain < 1)
        throw std::invalid_argument(
            "the sampler needs at least one chain, one kept sweep and no negative burn-in");
    GibbsDraws result{unknownBins(problem.known), {}};
    if (result.bins.empty()) return result;

    result.draws.assign(result.bins.size(), Eigen::MatrixXd(problem.keptPerChain, problem.chains));
    stopIfCancelled(watch);
    const int each = chainsPerPart(problem, watch);
    std::vector<std::unique_ptr<Sampler>> parts;  // made here, so that one thread polls
    for (int first = 0; first < problem.chains; first += each)
        parts.push_back(std::make_unique<Sampler>(conditionals, problem, first,
                                                  std::min(each, problem.chains - first)));
    const auto count = static_cast<int>(parts.size());
    Reporter reporter(watch, count * (problem.burnIn + problem.keptPerChain));
    const auto run = [&](int part) {
        runChains(*parts[static_cast<std::size_t>(part)], problem, part * each, reporter, result);
    };
    if (count > 1)
        watch.sideBySide(count, run);
    else
        run(0);
    reporter.step();
    return result;
}

GibbsDraws sampleHeights(const BinModels& models, const GibbsProblem& problem, const Watch& watch)
{
    const Poll poll = [&watch] { stopIfCancelled(watch); };
    return sampleStates(
        BinConditionals(models, problem.s, problem.precision, problem.inducing, poll), problem,
        watch);
}

}  // namespace terratact
