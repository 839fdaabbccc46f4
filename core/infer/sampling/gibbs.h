#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/settings.h"
#include "core/infer/sampling/conditionals.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/model/bin_models.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Problem of the Gibbs sampler: draw the states x_I of the unknown bins from the conditionals p(xᵢ
/// | x_{J∖i}, s), given the known states. With the paper's models a state is a height.
struct GibbsProblem {
    Eigen::VectorXd s;      ///< features of the models' set; read by sampleHeights only
    OptionalHeights known;  ///< fixed states: heights [m] with the paper's models
    Heights ceiling{};      ///< upper bounds of the states; +infinity: none
    CeilingRule rule = CeilingRule::Truncate;
    ScanOrder scan = ScanOrder::Forward;
    int chains = 16;
    int firstChain = 0;      ///< number of the first chain; it decides the chain's random numbers
    int burnIn = 50;         ///< discarded sweeps per chain
    int keptPerChain = 63;   ///< kept sweeps per chain, at most
    bool stopEarly = false;  ///< end earlier if the chains have converged
    /// Precision of variances; read by sampleHeights only.
    Precision precision = Precision::Single;
    int inducing = 0;  ///< inducing rows of the models, see Settings; read by sampleHeights only
    std::uint64_t seed = 1;
};

/// Throws std::invalid_argument with a sentence if a number of the settings is out of range.
void checkSettings(const Settings& settings);

/// Number of kept sweeps per chain at the first convergence check. Each later check comes after
/// half as many sweeps more.
inline constexpr int kFirstCheck = 25;
/// Smallest number of kept sweeps per chain, however little time there is. R-hat needs as many.
inline constexpr int kMinKept = 4;

/// Returns a problem with scan order, chains, sweeps, precision and seed from the settings. The
/// caller sets the rest.
GibbsProblem problemFor(const Settings& settings);

struct GibbsDraws {
    std::vector<int> bins;               ///< I, rear to front
    std::vector<Eigen::MatrixXd> draws;  ///< per bin of I: kept sweeps × chains, heights [m]
    Ending ending = Ending::NotSampled;
    int burnInLeftOut = 0;  ///< sweeps of the burn-in that were left out for lack of time
};

/// Samples as in section 4.3 of the paper. Chains start at random (Conditionals::start, with the
/// ceiling applied). Sweeps then draw every unknown bin in the order of `scan`, with the ceilings
/// applied by `rule`. Each chain has its own random numbers. Its draws depend on its number and the
/// seed only. The number of chains and the threads of watch.sideBySide have no effect. The
/// conditionals are trained one by one and need not belong to one joint distribution (a dependency
/// network). The result may therefore depend on the scan order. Sampling ends after keptPerChain
/// kept sweeps (Ending::Sweeps), or earlier:
///   - Ending::Converged, with stopEarly: the heights of every bin have R-hat ≤ kRhatLimit and
///     ESS ≥ kEssLimit. Checks come after 25, 38, 57 … sweeps and after the last kept sweep.
///     These numbers do not depend on the machine, so the same seed gives the same draws.
///   - Ending::Time: watch.outOfTime returned true, and there are kMinKept kept sweeps. The draws are
///     the first draws of a longer run. If time runs out during the burn-in, its rest is left out and
///     the next kMinKept sweeps are kept: these draws still depend on the chains' starts.
/// Throws std::invalid_argument unless chains ≥ 1, firstChain ≥ 0, burnIn ≥ 0, keptPerChain ≥ 1.
/// Throws Cancelled.
GibbsDraws sampleStates(const Conditionals& conditionals, const GibbsProblem& problem,
                        const Watch& watch = {});

/// Sampling of one scene in steps, for a caller that has several scenes.
class GibbsRun {
public:
    /// Throws as sampleStates. conditionals must outlive this object.
    GibbsRun(const Conditionals& conditionals, const GibbsProblem& problem,
             const Watch& watch = {});
    ~GibbsRun();

    int chains() const;
    bool ended() const;
    /// Returns what sampleStates returns, once ended() is true.
    GibbsDraws consumeDraws();

    /// Sweeps until the next decision is due. Groups of chains run in the threads of
    /// watch.sideBySide.
    void advance();

    /// Makes one sweep of every run in this thread; no run may have ended. Chains of all scenes
    /// that share a bin's Gaussian process pass through its factor together (predictTogether). A
    /// scene that knows the bin's state skips it. The draws and the end of each run equal those of
    /// sampleStates bit for bit, except under a time limit.
    /// ScanOrder::Random gains nothing: every scene has its own order and rarely meets another.
    /// Throws Cancelled; the runs cannot continue after that.
    static void sweepTogether(std::span<GibbsRun* const> runs, PredictionRoom& room);

private:
    struct Chains;
    std::unique_ptr<Chains> chains_;
};

/// Samples heights [m] from the paper's models at problem.s. Chains start from the training set's
/// mean and standard deviation. Throws as sampleStates.
GibbsDraws sampleHeights(const BinModels& models, const GibbsProblem& problem,
                         const Watch& watch = {});

}  // namespace terratact
