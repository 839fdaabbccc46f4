#include "app/modelling/truth/truth_choices.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr double kNudgeStep = 1e-5;  // [m], [rad] sums of steps are rounded to it

double nudgedBy(double value, double by, double most)
{
    return std::clamp(std::round((value + by) / kNudgeStep) * kNudgeStep, -most, most) + 0.0;
}

bool isSame(const TruthDecision& a, const TruthDecision& b)
{
    return a.kind == b.kind && a.offset == b.offset && a.tilt == b.tilt && a.along == b.along;
}

}  // namespace

void TruthChoices::load(const std::vector<TruthDecision>& decisions)
{
    chosen_.clear();
    past_.clear();
    for (const TruthDecision& decision : decisions) {
        TruthDecision& own = chosen_[decision.row - 1] = decision;
        own.run = truth_.runOf(decision.row - 1);
    }
}

const TruthDecision* TruthChoices::decision(std::size_t row) const
{
    const auto found = chosen_.find(row);
    return found == chosen_.end() ? nullptr : &found->second;
}

std::vector<TruthDecision> TruthChoices::decisions() const
{
    std::vector<TruthDecision> all;
    all.reserve(chosen_.size());
    for (const auto& [row, decision] : chosen_) all.push_back(decision);
    return all;
}

std::size_t TruthChoices::count(TruthDecision::Kind kind) const
{
    return static_cast<std::size_t>(std::ranges::count_if(
        chosen_, [kind](const auto& entry) { return entry.second.kind == kind; }));
}

TruthDecision TruthChoices::current(std::size_t row) const
{
    if (const TruthDecision* const made = decision(row)) return *made;
    return {.row = row + 1, .run = truth_.runOf(row)};
}

void TruthChoices::change(std::size_t row, const TruthDecision& to)
{
    const TruthDecision* const before = decision(row);
    if (before && isSame(*before, to)) return;
    past_.push_back({row, before ? std::optional(*before) : std::nullopt});
    chosen_[row] = to;
}

void TruthChoices::accept(std::size_t row)
{
    TruthDecision to = current(row);
    to.kind = TruthDecision::Kind::Accept;
    change(row, to);
}

void TruthChoices::exclude(std::size_t row)
{
    TruthDecision to = current(row);
    to.kind = TruthDecision::Kind::Exclude;
    change(row, to);
}

void TruthChoices::nudge(std::size_t row, double offset, double tilt, double along)
{
    TruthDecision to = current(row);
    to.kind = TruthDecision::Kind::Accept;
    to.offset = nudgedBy(to.offset, offset, kMaxNudge);
    to.tilt = nudgedBy(to.tilt, tilt, kMaxNudgeTilt);
    to.along = nudgedBy(to.along, along, kMaxNudgeAlong);
    change(row, to);
}

void TruthChoices::removeNudge(std::size_t row)
{
    TruthDecision to = current(row);
    if (to.offset == 0.0 && to.tilt == 0.0 && to.along == 0.0) return;
    to.offset = to.tilt = to.along = 0.0;
    change(row, to);
}

std::optional<std::size_t> TruthChoices::undo()
{
    if (past_.empty()) return std::nullopt;
    const Change last = past_.back();
    past_.pop_back();
    if (last.before)
        chosen_[last.row] = *last.before;
    else
        chosen_.erase(last.row);
    return last.row;
}

std::optional<std::size_t> TruthChoices::nextOpen(std::size_t from) const
{
    const std::size_t n = truth_.scenes();
    for (std::size_t k = 1; k <= n; ++k) {
        const std::size_t row = (from + k) % n;
        if (truth_.truths[row].gap == TruthGap::None && !decision(row)) return row;
    }
    return std::nullopt;
}

}  // namespace terratact
