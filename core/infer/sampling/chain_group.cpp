#include "core/infer/sampling/chain_group.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/infer/sampling/truncated_normal.h"

namespace terratact {

namespace {

/// Draws one height from N(mean, sd²) with the ceiling applied.
double draw(double mean, double sd, double ceiling, CeilingRule rule, std::mt19937_64& rng)
{
    const double none = std::numeric_limits<double>::infinity();
    if (rule == CeilingRule::Truncate) return drawBelow(ceiling, mean, sd, rng);
    const double free = drawBelow(none, mean, sd, rng);
    return rule == CeilingRule::Clamp ? std::min(free, ceiling) : free;
}

/// Returns the first of the groups' next bins in scan order, so that scenes with different unknown
/// bins meet again.
std::optional<int> firstBin(std::optional<int> a, std::optional<int> b, ScanOrder scan)
{
    if (!a || !b) return a ? a : b;
    return scan == ScanOrder::Reverse ? std::max(*a, *b) : std::min(*a, *b);
}

}  // namespace

std::vector<int> unknownBins(const OptionalHeights& known)
{
    std::vector<int> bins;
    for (int i = 0; i < kBins; ++i)
        if (!known[static_cast<std::size_t>(i)]) bins.push_back(i);
    return bins;
}

SweepOrder::SweepOrder(ScanOrder scan, std::uint64_t seed) : scan_(scan)
{
    std::seed_seq words{seed & 0xffffffffU, seed >> 32U, std::uint64_t{0}, std::uint64_t{1}};
    rng_.seed(words);  // four words: no chain's generator has this seed
}

const std::vector<std::size_t>& SweepOrder::next(std::size_t count)
{
    if (order_.size() != count) {
        order_.resize(count);
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        if (scan_ == ScanOrder::Reverse) std::reverse(order_.begin(), order_.end());
    }
    if (scan_ == ScanOrder::Random) shuffle();
    return order_;
}

/// Shuffles by Fisher and Yates; the remainder's bias is below 1e-18. The result is the same with
/// every standard library.
void SweepOrder::shuffle()
{
    for (std::size_t left = order_.size(); left > 1; --left)
        std::swap(order_[left - 1], order_[rng_() % left]);
}

ChainGroup::ChainGroup(const Conditionals& conditionals, const GibbsProblem& problem, int first,
                       int count, Poll poll)
    : problem_(problem), poll_(std::move(poll)), bins_(unknownBins(problem.known)),
      order_(problem.scan, problem.seed)
{
    PolledWork work(poll_);
    for (int c = 0; c < count; ++c) {
        work.done(std::mt19937_64::state_size);
        std::seed_seq seed{problem.seed & 0xffffffffU, problem.seed >> 32U,
                           static_cast<std::uint64_t>(problem.firstChain + first + c)};
        rng_.emplace_back(seed);
    }
    startRandomly(conditionals);
    Heights known{};
    for (std::size_t i = 0; i < kBins; ++i) known[i] = problem.known[i].value_or(0.0);
    conditionals_ = conditionals.at(known, bins_);
}

void ChainGroup::startRandomly(const Conditionals& conditionals)
{
    states_.resize(static_cast<Eigen::Index>(bins_.size()), static_cast<Eigen::Index>(rng_.size()));
    PolledWork work(poll_);
    for (std::size_t c = 0; c < rng_.size(); ++c)
        for (std::size_t k = 0; k < bins_.size(); ++k) {
            work.done(2);
            const StartDraw start = conditionals.start(bins_[k]);
            drawState(k, c, start.mean, start.sd);
        }
}

void ChainGroup::drawState(std::size_t k, std::size_t c, double mean, double sd)
{
    const double ceiling = problem_.ceiling[static_cast<std::size_t>(bins_[k])];
    states_(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(c)) =
        draw(mean, sd, ceiling, problem_.rule, rng_[c]);
}

void ChainGroup::begin()
{
    left_ = order_.next(bins_.size());
}

std::optional<int> ChainGroup::nextBin() const
{
    if (left_.empty()) return std::nullopt;
    return bins_[left_.front()];
}

/// Returns the question for the next bin's process. Without a process, the next bin's mean and
/// variance are complete.
std::optional<ScenePrediction> ChainGroup::ask()
{
    callPoll(poll_);
    auto asked = conditionals_->ask(left_.front(), states_, mean_, variance_);
    if (!asked) conditionals_->predict(left_.front(), states_, mean_, variance_);
    return asked;
}

void ChainGroup::drawNext()
{
    const std::size_t k = left_.front();
    left_ = left_.subspan(1);
    conditionals_->complete(k, mean_, variance_);
    PolledWork work(poll_);
    for (std::size_t c = 0; c < rng_.size(); ++c) {
        work.done(2);
        const auto column = static_cast<Eigen::Index>(c);
        drawState(k, c, mean_[column], std::sqrt(variance_[column]));
    }
}

void ChainGroup::sweep(std::span<ChainGroup* const> groups, PredictionRoom& room)
{
    const Poll poll = [groups] {
        for (const ChainGroup* group : groups) callPoll(group->poll_);
    };
    for (ChainGroup* group : groups) group->begin();
    std::vector<ScenePrediction> asked;
    for (;;) {
        std::optional<int> bin;
        for (const ChainGroup* group : groups)
            bin = firstBin(bin, group->nextBin(), group->problem_.scan);
        if (!bin) return;
        asked.clear();
        for (ChainGroup* group : groups) {
            if (group->nextBin() != bin) continue;
            if (const auto one = group->ask()) asked.push_back(*one);
        }
        predictTogether(asked, room, poll);
        for (ChainGroup* group : groups) {
            if (group->nextBin() != bin) continue;
            group->drawNext();
        }
    }
}

}  // namespace terratact
