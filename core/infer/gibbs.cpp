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
#include "core/infer/convergence.h"
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

    /// Before each sweep.
    void step()
    {
        const std::scoped_lock lock(mutex_);
        if (watch_.progress) watch_.progress(static_cast<double>(done_) / total_);
        ++done_;
    }

    void end()
    {
        const std::scoped_lock lock(mutex_);
        if (watch_.progress) watch_.progress(1.0);
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

    const std::vector<int>& bins() const { return bins_; }
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

/// Chains that one thread runs: full groups of columns, two where that still makes several parts.
int chainsPerPart(const GibbsProblem& problem, const Watch& watch)
{
    if (!watch.sideBySide) return problem.chains;
    return problem.chains > 4 * kGroup ? 2 * kGroup : kGroup;
}

/// All chains, in parts that may advance side by side, and the heights they have drawn.
class Chains {
public:
    Chains(const Conditionals& conditionals, const GibbsProblem& problem, const Watch& watch)
        : conditionals_(conditionals), problem_(problem), watch_(watch),
          each_(chainsPerPart(problem, watch)), done_(-problem.burnIn),
          draws_(unknownBins(problem.known).size(), Eigen::MatrixXd(0, problem.chains)),
          reporter_(watch,
                    (problem.chains + each_ - 1) / each_ * (problem.burnIn + problem.keptPerChain))
    {
        stopIfCancelled(watch);
        for (int first = 0; first < problem.chains; first += each_)  // here: one thread polls
            parts_.push_back(std::make_unique<Sampler>(conditionals, problem, first,
                                                       std::min(each_, problem.chains - first)));
    }

    const std::vector<Eigen::MatrixXd>& draws() const { return draws_; }
    std::vector<Eigen::MatrixXd> takeDraws() { return std::move(draws_); }

    /// Sweeps until so many are kept; false where time ran out before.
    bool advanceTo(int kept)
    {
        for (Eigen::MatrixXd& d : draws_) d.conservativeResize(kept, Eigen::NoChange);
        const int least = std::min(kLeastKept, problem_.keptPerChain);
        while (done_ < kept) {
            if (done_ >= least && watch_.outOfTime && watch_.outOfTime()) break;
            round(std::min(kept - done_, sweepsPerRound()));
        }
        for (Eigen::MatrixXd& d : draws_) d.conservativeResize(done_, Eigen::NoChange);
        return done_ == kept;
    }

    void reportEnd() { reporter_.end(); }

private:
    int sweepsPerRound() const
    {
        constexpr int kSideBySide = 4;  // so that starting threads costs little
        if (!watch_.outOfTime) return std::numeric_limits<int>::max();
        return parts_.size() > 1 ? kSideBySide : 1;
    }

    void round(int sweeps)
    {
        const auto count = static_cast<int>(parts_.size());
        const auto run = [&](int part) {
            for (int sweep = done_; sweep < done_ + sweeps; ++sweep) {
                reporter_.step();
                parts_[static_cast<std::size_t>(part)]->sweep(reporter_);
                if (sweep >= 0) keep(part, sweep);
            }
        };
        if (count > 1)
            watch_.sideBySide(count, run);
        else
            run(0);
        done_ += sweeps;
    }

    void keep(int part, int row)
    {
        const Sampler& sampler = *parts_[static_cast<std::size_t>(part)];
        const Eigen::Index first = static_cast<Eigen::Index>(part) * each_;
        for (std::size_t k = 0; k < draws_.size(); ++k)
            for (Eigen::Index c = 0; c < sampler.states().cols(); ++c)
                draws_[k](row, first + c) = conditionals_.height(
                    sampler.bins()[k], sampler.states()(static_cast<Eigen::Index>(k), c));
    }

    const Conditionals& conditionals_;
    const GibbsProblem& problem_;
    const Watch& watch_;
    int each_;
    int done_;  // kept sweeps; negative during the burn-in
    std::vector<Eigen::MatrixXd> draws_;
    Reporter reporter_;
    std::vector<std::unique_ptr<Sampler>> parts_;
};

/// Whether every bin's draws are within the limits.
class Judge {
public:
    bool converged(const std::vector<Eigen::MatrixXd>& draws)
    {
        for (std::size_t k = 0; k < draws.size(); ++k) {
            const std::size_t bin = (doubtful_ + k) % draws.size();
            if (bulkEss(draws[bin]) >= kEssLimit && rankNormalisedRhat(draws[bin]) <= kRhatLimit)
                continue;
            doubtful_ = bin;
            return false;
        }
        return true;
    }

private:
    std::size_t doubtful_ = 0;  // the bin that failed last comes first: mostly it fails again
};

Ending sample(Chains& chains, const GibbsProblem& problem)
{
    Judge judge;
    int kept = problem.stopEarly ? kFirstCheck : problem.keptPerChain;
    for (;; kept += (kept + 1) / 2) {
        kept = std::min(kept, problem.keptPerChain);
        if (!chains.advanceTo(kept)) return Ending::Time;
        if (problem.stopEarly && judge.converged(chains.draws())) return Ending::Converged;
        if (kept == problem.keptPerChain) return Ending::Sweeps;
    }
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
    problem.stopEarly = settings.stopEarly;
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
    Chains chains(conditionals, problem, watch);
    result.ending = sample(chains, problem);
    result.draws = chains.takeDraws();
    chains.reportEnd();
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
