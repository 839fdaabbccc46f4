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

/// What the sampler is asked: draw the states x_I of the unknown bins from the conditionals
/// p(xᵢ | x_{J∖i}, s), given the known ones.  With the paper's models a state is a height.
struct GibbsProblem {
    Eigen::VectorXd s;      ///< features of the models' set; read by sampleHeights only
    OptionalHeights known;  ///< states that are kept as they are: heights [m]
    Heights ceiling{};      ///< upper bounds of states; +infinity where there is none
    CeilingRule rule = CeilingRule::Truncate;
    ScanOrder scan = ScanOrder::Forward;
    int chains = 16;
    int firstChain = 0;      ///< number of the first chain: it decides the chain's random numbers
    int burnIn = 50;         ///< sweeps per chain that are thrown away
    int keptPerChain = 63;   ///< sweeps per chain that are kept, at most
    bool stopEarly = false;  ///< ends before that where the chains have converged
    Precision precision = Precision::Single;  ///< of variances; read by sampleHeights only
    int inducing = 0;  ///< of the models, see Settings; read by sampleHeights only
    std::uint64_t seed = 1;
};

/// Throws std::invalid_argument, a sentence, where a number of the settings is out of range.
void checkSettings(const Settings& settings);

/// Kept sweeps per chain after which chains are first judged; again after half as many more, and so on.
inline constexpr int kFirstCheck = 25;
/// Kept sweeps per chain that there are at least, however little time there is: R-hat needs as many.
inline constexpr int kMinKept = 4;

/// Scan order, chains, sweeps, precision and seed from the settings; everything else is left to fill in.
GibbsProblem problemFor(const Settings& settings);

struct GibbsDraws {
    std::vector<int> bins;               ///< I, rear to front
    std::vector<Eigen::MatrixXd> draws;  ///< per bin of I: kept sweeps × chains, heights [m]
    Ending ending = Ending::NotSampled;
    int burnInLeftOut = 0;  ///< sweeps of the burn-in that there was no time for
};

/// Section 4.3: random start (Conditionals::start, the ceiling applied), then sweeps that draw every
/// unknown bin in the order of `scan`, ceilings applied by `rule`.  Chains advance side by side, each
/// with its own random numbers: a chain's draws depend on its number and the seed, not on how many others run nor
/// on whether watch.sideBySide runs groups of them in several threads.
/// The conditionals are trained one by one and need not belong to one joint distribution: the result may
/// depend on the order of the scan (domain: "dependency network").
/// Ends after keptPerChain kept sweeps (Ending::Sweeps), or
///   - with stopEarly, where the heights of every bin have R-hat ≤ kRhatLimit and ESS ≥ kEssLimit, judged after 25,
///     38, 57 … and after the last kept sweep (Ending::Converged): numbers of sweeps that do not depend on the
///     machine, so the same seed gives the same draws;
///   - when watch.outOfTime says so, but not before kMinKept kept sweeps (Ending::Time): the draws are the first
///     of those that more time would have given.  Said during the burn-in, the next kMinKept sweeps are kept and
///     the rest of the burn-in is left out: draws that still depend on where the chains started.
/// Throws std::invalid_argument unless chains ≥ 1, firstChain ≥ 0, burnIn ≥ 0, keptPerChain ≥ 1; Cancelled.
GibbsDraws sampleStates(const Conditionals& conditionals, const GibbsProblem& problem,
                        const Watch& watch = {});

/// The sampling of one scene in steps, for a caller who has several scenes.
class GibbsRun {
public:
    /// Throws as sampleStates.  conditionals must live as long as this does.
    GibbsRun(const Conditionals& conditionals, const GibbsProblem& problem,
             const Watch& watch = {});
    ~GibbsRun();

    int chains() const;
    bool ended() const;
    /// What sampleStates returns, once ended().
    GibbsDraws takeDraws();

    /// Sweeps until there is something to decide, groups of chains in threads where watch.sideBySide runs them.
    void advance();

    /// One sweep of every run, in this thread; none may have ended.  Chains of all scenes go through a bin's factor
    /// side by side (predictTogether), where scenes have the bin's Gaussian process in common; a scene that knows the
    /// bin's state takes no part there.  Each run's draws and its end are those of sampleStates, bit for bit, where time
    /// does not end it.
    /// Not worth it with ScanOrder::Random, where every scene has its own order and seldom meets another.
    /// Throws Cancelled; the runs cannot go on then.
    static void sweepTogether(std::span<GibbsRun* const> runs, PredictionRoom& room);

private:
    struct Chains;
    std::unique_ptr<Chains> chains_;
};

/// The same from the paper's models at problem.s: heights [m], the start from the training set's mean and
/// deviation.
GibbsDraws sampleHeights(const BinModels& models, const GibbsProblem& problem,
                         const Watch& watch = {});

}  // namespace terratact
