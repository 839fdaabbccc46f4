#include "core/infer/sampling/gibbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "core/infer/sampling/bin_conditionals.h"
#include "core/infer/sampling/chain_group.h"
#include "core/infer/sampling/convergence.h"
#include "core/learn/kernels/covariance_kernels.h"

namespace terratact {

namespace {

/// Calls the watch for all threads, one at a time.
class Reporter {
public:
    Reporter(const Watch& watch, double total) : watch_(watch), total_(total) {}

    void stopIfCancelled()
    {
        const std::scoped_lock lock(mutex_);
        terratact::stopIfCancelled(watch_);
    }

    /// Called before each sweep.
    void step()
    {
        const std::scoped_lock lock(mutex_);
        if (watch_.progress) watch_.progress(done_ / total_);
        done_ += 1.0;
    }

    void end()
    {
        const std::scoped_lock lock(mutex_);
        if (watch_.progress) watch_.progress(1.0);
    }

private:
    const Watch& watch_;
    double total_;
    std::mutex mutex_;
    double done_ = 0.0;
};

/// Returns the number of chains per thread: full groups of columns, and no more parts than threads.
/// Neighbouring groups share a factor that is already in the cache.
int chainsPerPart(const GibbsProblem& problem, const Watch& watch)
{
    if (!watch.sideBySide) return problem.chains;
    if (watch.threads == 0) return kGroup;
    return kGroup * ((groupsOf(problem.chains) + watch.threads - 1) / watch.threads);
}

/// Checks whether every bin's draws have converged.
class Judge {
public:
    bool converged(const GibbsDraws& drawn, const Heights& ceiling, const Poll& poll)
    {
        const std::size_t count = drawn.bins.size();
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t k = (doubtful_ + n) % count;
            const auto bin = static_cast<std::size_t>(drawn.bins[k]);
            RankedDraws ranked(drawn.draws[k], poll, ceiling[bin]);
            if (ranked.ess() >= kEssLimit && ranked.rhat() <= kRhatLimit) continue;
            doubtful_ = k;
            return false;
        }
        return true;
    }

private:
    // the bin that failed last is checked first, for it mostly fails again
    std::size_t doubtful_ = 0;
};

}  // namespace

void checkSettings(const Settings& settings)
{
    if (settings.draws < 1 || settings.draws > kMaxDraws || settings.chains < 1
        || settings.chains > kMaxChains || settings.burnIn < 0 || settings.burnIn > kMaxBurnIn)
        throw std::invalid_argument(fmt::format(
            "an estimate needs 1 to {} draws, 1 to {} chains and a burn-in of 0 to {} sweeps",
            kMaxDraws, kMaxChains, kMaxBurnIn));
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

/// All chains of one scene, in parts that may advance in parallel, and the heights drawn so far.
struct GibbsRun::Chains {
    Chains(const Conditionals& from, const GibbsProblem& asked, const Watch& who)
        : conditionals(from), problem(asked), watch(who), each(chainsPerPart(asked, who)),
          done(-asked.burnIn),
          reporter(watch, std::ceil(static_cast<double>(asked.chains) / each)
                              * (static_cast<double>(asked.burnIn) + asked.keptPerChain))
    {
        stopIfCancelled(watch);
        result.bins = unknownBins(problem.known);
        if (result.bins.empty()) {
            ended = true;
            return;
        }
        result.draws.assign(result.bins.size(), Eigen::MatrixXd(0, problem.chains));
        for (int first = 0; first < problem.chains; first += each)  // one thread polls here
            parts.push_back(std::make_unique<ChainGroup>(
                conditionals, problem, first, std::min(each, problem.chains - first), poll));
        rooms.resize(parts.size());
        goOnTo(problem.stopEarly ? kFirstCheck : problem.keptPerChain);
    }

    /// Sets the next number of kept sweeps at which convergence is checked.
    void goOnTo(int kept)
    {
        check = std::min(kept, problem.keptPerChain);
        resize(check);
    }

    /// Resizes the draws to this number of sweeps per chain.
    void resize(int kept)
    {
        for (Eigen::MatrixXd& draws : result.draws) {
            if (draws.rows() == kept) continue;
            PolledWork work(poll);
            Eigen::MatrixXd resized(kept, draws.cols());
            const Eigen::Index both = std::min<Eigen::Index>(kept, draws.rows());
            for (Eigen::Index c = 0; c < draws.cols(); ++c)
                transformPolled(draws.col(c).data(), both, resized.col(c).data(), work,
                                [](double draw) { return draw; });
            draws = std::move(resized);
        }
    }

    /// Returns the number of sweeps until the next decision.
    int sweepsAhead() const
    {
        constexpr int kSideBySide = 4;  // keeps the cost of starting threads small
        if (!watch.outOfTime) return check - done;
        return std::min(check - done, parts.size() > 1 ? kSideBySide : 1);
    }

    /// Writes what a part has drawn in this sweep.
    void keep(std::size_t part, int sweep)
    {
        if (sweep < 0) return;
        const ChainGroup& group = *parts[part];
        const Eigen::Index first = static_cast<Eigen::Index>(part) * each;
        for (std::size_t k = 0; k < result.draws.size(); ++k)
            for (Eigen::Index c = 0; c < group.states().cols(); ++c)
                result.draws[k](sweep, first + c) = conditionals.height(
                    group.bins()[k], group.states()(static_cast<Eigen::Index>(k), c));
    }

    bool outOfTime() const { return watch.outOfTime && watch.outOfTime(); }

    void count(int sweeps)
    {
        done += sweeps;
        if (done < 0) {
            if (outOfTime()) leaveOutBurnIn();
            return;
        }
        if (done == check) {
            if (result.burnInLeftOut > 0) return end(Ending::Time);
            if (problem.stopEarly && judge.converged(result, problem.ceiling, poll))
                return end(Ending::Converged);
            if (done == problem.keptPerChain) return end(Ending::Sweeps);
            goOnTo(check + (check + 1) / 2);
        }
        if (done >= std::min(kMinKept, problem.keptPerChain) && outOfTime()) end(Ending::Time);
    }

    /// Ends the burn-in: only the next kMinKept sweeps are kept.
    void leaveOutBurnIn()
    {
        result.burnInLeftOut = -done;
        done = 0;
        goOnTo(kMinKept);
    }

    void end(Ending why)
    {
        ended = true;
        result.ending = why;
        resize(done);
        reporter.end();
    }

    const Conditionals& conditionals;
    const GibbsProblem problem;
    const Watch watch;
    const int each;  // chains of a part
    int done;        // kept sweeps; negative during the burn-in
    int check = 0;
    bool ended = false;
    GibbsDraws result;
    Judge judge;
    Reporter reporter;
    const Poll poll = [this] { reporter.stopIfCancelled(); };
    std::vector<std::unique_ptr<ChainGroup>> parts;
    std::vector<PredictionRoom> rooms;  // one for each part
};

GibbsRun::GibbsRun(const Conditionals& conditionals, const GibbsProblem& problem,
                   const Watch& watch)
{
    if (problem.chains < 1 || problem.firstChain < 0 || problem.burnIn < 0
        || problem.keptPerChain < 1)
        throw std::invalid_argument(
            "the sampler needs at least one chain, one kept sweep and no negative burn-in");
    chains_ = std::make_unique<Chains>(conditionals, problem, watch);
}

GibbsRun::~GibbsRun() = default;

int GibbsRun::chains() const
{
    return chains_->problem.chains;
}

bool GibbsRun::ended() const
{
    return chains_->ended;
}

GibbsDraws GibbsRun::consumeDraws()
{
    return std::move(chains_->result);
}

void GibbsRun::advance()
{
    Chains& chains = *chains_;
    const int sweeps = chains.sweepsAhead();
    const auto run = [&](int number) {
        const auto part = static_cast<std::size_t>(number);
        ChainGroup* const group = chains.parts[part].get();
        PredictionRoom& room = chains.rooms[part];
        for (int sweep = chains.done; sweep < chains.done + sweeps; ++sweep) {
            chains.reporter.step();
            ChainGroup::sweep({&group, 1}, room);
            chains.keep(part, sweep);
        }
    };
    if (chains.parts.size() > 1)
        chains.watch.sideBySide(static_cast<int>(chains.parts.size()), run);
    else
        run(0);
    chains.count(sweeps);
}

void GibbsRun::sweepTogether(std::span<GibbsRun* const> runs, PredictionRoom& room)
{
    std::vector<ChainGroup*> groups;
    for (GibbsRun* run : runs) {
        run->chains_->reporter.step();
        for (const auto& part : run->chains_->parts) groups.push_back(part.get());
    }
    ChainGroup::sweep(groups, room);
    for (GibbsRun* run : runs) {
        Chains& chains = *run->chains_;
        for (std::size_t part = 0; part < chains.parts.size(); ++part)
            chains.keep(part, chains.done);
        chains.count(1);
    }
}

GibbsDraws sampleStates(const Conditionals& conditionals, const GibbsProblem& problem,
                        const Watch& watch)
{
    GibbsRun run(conditionals, problem, watch);
    while (!run.ended()) run.advance();
    return run.consumeDraws();
}

GibbsDraws sampleHeights(const BinModels& models, const GibbsProblem& problem, const Watch& watch)
{
    return sampleStates(
        BinConditionals(models, problem.s, problem.precision, problem.inducing, pollOf(watch)),
        problem, watch);
}

}  // namespace terratact
