#include "app/modelling/trials/drive_scores.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace terratact {
namespace {

constexpr std::size_t kScoredBins = 9;  // -0.3 … 0.5 m

double medianOf(std::vector<double> values)
{
    if (values.empty()) return std::nan("");
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

double meanOf(const std::vector<double>& values)
{
    if (values.empty()) return std::nan("");
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Errors of some bins over all sides.
struct BinErrors {
    std::vector<double> errors;
    double inside = 0.0;

    void add(const JudgedSide& side, std::size_t bin)
    {
        if (std::isnan(side.error.at(bin))) return;
        errors.push_back(side.error.at(bin));
        inside += side.inside.at(bin) ? 1.0 : 0.0;
    }
    double cover() const
    {
        return errors.empty() ? std::nan("") : inside / static_cast<double>(errors.size());
    }
};

}  // namespace

JudgedSide judgedSide(const TerrainEstimate& estimate, const OptionalHeights& truth, bool early)
{
    JudgedSide side;
    side.isEarly = early;
    for (std::size_t i = 0; i < kBins; ++i) {
        side.error[i] = truth[i] ? std::abs(estimate.height[i] - *truth[i]) : std::nan("");
        side.inside[i] = truth[i] && estimate.q10[i] <= *truth[i] && *truth[i] <= estimate.q90[i];
    }
    return side;
}

DriveScores scoresOf(const std::string& name, const std::vector<JudgedSide>& sides, bool early,
                     const std::vector<double>& cpu)
{
    BinErrors scored;
    std::array<BinErrors, kBins> bins;
    for (const JudgedSide& side : sides) {
        if (side.isEarly != early) continue;
        for (std::size_t i = 0; i < kBins; ++i) {
            bins.at(i).add(side, i);
            if (i < kScoredBins) scored.add(side, i);
        }
    }
    DriveScores scores;
    scores.name = name;
    scores.median = medianOf(scored.errors);
    scores.mean = meanOf(scored.errors);
    scores.in80 = scored.cover();
    scores.cpu = medianOf(cpu);
    for (std::size_t i = 0; i < kBins; ++i) {
        scores.medians.at(i) = medianOf(bins.at(i).errors);
        scores.means.at(i) = meanOf(bins.at(i).errors);
        scores.cover.at(i) = bins.at(i).cover();
    }
    return scores;
}

}  // namespace terratact
