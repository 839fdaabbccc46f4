#include "core/atem/probe/probe_gain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/base/normal.h"
#include "core/infer/verdict/obstacle.h"

namespace terratact {
namespace {

constexpr std::size_t kReadings = 48;

/// Joint draws of one side or of both.
using DrawsBySide = std::vector<const std::vector<Heights>*>;

/// Draws of all bins, prepared for V and H.
class Draws {
public:
    Draws(DrawsBySide sides, double stepLimit, int firstBin, const Poll& poll)
        : sides_(std::move(sides)), step_(count()), squares_(count())
    {
        PolledWork work(poll);
        for (const std::vector<Heights>* side : sides_) add(*side, stepLimit, firstBin, work);
    }

    std::size_t count() const { return sides_.front()->size(); }

    /// Returns the height of one bin of a side in every draw [m].
    std::vector<double> of(std::size_t side, std::size_t bin, PolledWork& work) const
    {
        std::vector<double> heights;
        heights.reserve(count());
        for (const Heights& h : *sides_[side]) {
            work.done();
            heights.push_back(h[bin]);
        }
        return heights;
    }

    /// Returns V(w) [m²]; 0 if one draw has all the weight. Σ w (h − m)² = Σ w h² − m² with m = Σ w
    /// h takes one pass. The heights are centred, so that no relevant digits are lost.
    double variance(const std::vector<double>& weight, PolledWork& work) const
    {
        std::vector<Heights> means(sides_.size(), Heights{});
        double alone = 0.0, second = 0.0;
        for (std::size_t d = 0; d < count(); ++d) {
            work.done(1);
            const double w = weight[d];
            if (w == 0.0) continue;
            alone += w * w;
            second += w * squares_[d];
            for (std::size_t side = 0; side < means.size(); ++side)
                for (std::size_t i = 0; i < kBins; ++i) means[side][i] += w * centred_[side][d][i];
        }
        for (const Heights& mean : means)
            for (const double m : mean) second -= m * m;
        constexpr double kAlone = 1e-9;
        return 1.0 - alone > kAlone ? std::max(0.0, second) / (1.0 - alone) : 0.0;
    }

    std::vector<double> equalWeights() const
    {
        return std::vector<double>(count(), 1.0 / static_cast<double>(count()));
    }

    /// Returns H(w) [nat].
    double entropy(const std::vector<double>& weight, PolledWork& work) const
    {
        double p = 0.0;
        for (std::size_t d = 0; d < count(); ++d) {
            work.done();
            p += weight[d] * step_[d];
        }
        const auto part = [](double q) { return q > 0.0 ? -q * std::log(q) : 0.0; };
        return part(p) + part(1.0 - p);
    }

private:
    void add(const std::vector<Heights>& heights, double stepLimit, int firstBin, PolledWork& work)
    {
        Heights mean{};
        for (const Heights& h : heights) {
            work.done(kBins);
            for (std::size_t i = 0; i < kBins; ++i)
                mean[i] += h[i] / static_cast<double>(heights.size());
        }
        std::vector<Heights>& centred = centred_.emplace_back();
        centred.reserve(heights.size());
        for (std::size_t d = 0; d < heights.size(); ++d) {
            work.done(kBins);
            if (hasStep(heights[d], stepLimit, firstBin)) step_[d] = 1.0;
            Heights& h = centred.emplace_back(heights[d]);
            double square = 0.0;
            for (std::size_t i = 0; i < kBins; ++i) {
                h[i] -= mean[i];
                square += h[i] * h[i];
            }
            squares_[d] += square;
        }
    }

    DrawsBySide sides_;
    std::vector<std::vector<Heights>> centred_;  // of each side, centred on their mean
    std::vector<double> step_;                   // 1 for a draw with a step on one side or both
    std::vector<double> squares_;                // Σ over the bins of a centred draw's squares
};

/// Returns evenly spaced quantiles of the expected readings of a bin with these draws.
std::vector<double> readings(const std::vector<double>& heights, double armSd, PolledWork& work)
{
    std::vector<double> all;
    all.reserve(heights.size());
    double u = 0.5;
    for (const double height : heights) {
        work.done(4);
        double& z = all.emplace_back(height);
        z += armSd * normalQuantile(u);
        u += std::numbers::phi - 1.0;
        u -= std::floor(u);
        u = std::clamp(u, 1e-9, 1.0 - 1e-9);
    }
    std::sort(all.begin(), all.end(), [&work](double a, double b) {
        work.done();
        return a < b;
    });
    std::vector<double> picked(kReadings);
    for (std::size_t k = 0; k < kReadings; ++k)
        picked[k] = all[(2 * k + 1) * all.size() / (2 * kReadings)];
    return picked;
}

/// Returns w_d ∝ N(reading; heights[d], armSd²), computed in logarithms until the largest is 1.
std::vector<double> weights(const std::vector<double>& heights, double reading, double armSd,
                            PolledWork& work)
{
    std::vector<double> w;
    w.reserve(heights.size());
    for (const double h : heights) {
        work.done();
        const double z = (reading - h) / armSd;
        w.push_back(-0.5 * z * z);
    }
    const double largest = *std::max_element(w.begin(), w.end());
    constexpr double kNothing = -40.0;  // e^-40 of the largest changes no digit
    double sum = 0.0;
    for (double& weight : w) {
        work.done();
        weight -= largest;
        sum += weight = weight > kNothing ? std::exp(weight) : 0.0;
    }
    for (double& weight : w) {
        work.done();
        weight /= sum;
    }
    return w;
}

/// Returns the mean of V and H over the readings of a bin of a side.
ProbeGain expectedAfter(const Draws& draws, std::size_t side, int bin, double armSd,
                        const Poll& poll)
{
    PolledWork work(poll);
    const std::vector<double> heights = draws.of(side, static_cast<std::size_t>(bin), work);
    ProbeGain after{bin, 0.0, 0.0};
    for (const double z : readings(heights, armSd, work)) {
        const std::vector<double> w = weights(heights, z, armSd, work);
        after.varianceReduction += draws.variance(w, work) / kReadings;
        after.entropyReduction += draws.entropy(w, work) / kReadings;
    }
    return after;
}

Draws drawsOf(DrawsBySide sides, double stepLimit, int firstBin, const Poll& poll)
{
    if (!(stepLimit >= 0.0) || !std::isfinite(stepLimit))
        throw std::invalid_argument("probeGains: stepLimit must be finite and 0 m or more");
    if (firstBin < 0 || firstBin >= kBins - 1)
        throw std::invalid_argument("probeGains: no such pair of bins");
    for (const std::vector<Heights>* side : sides) {
        if (side->empty()) throw std::invalid_argument("probeGains: no draws");
        if (side->size() != sides.front()->size())
            throw std::invalid_argument("probeGains: both sides need the same number of draws");
    }
    return {std::move(sides), stepLimit, firstBin, poll};
}

DrawsBySide bothOf(const TwoTrackEstimate& estimate)
{
    return {&estimate.side[0].draws, &estimate.side[1].draws};
}

Uncertainty uncertaintyOf(const Draws& draws, const Poll& poll)
{
    PolledWork work(poll);
    const std::vector<double> equal = draws.equalWeights();
    return {draws.variance(equal, work), draws.entropy(equal, work)};
}

/// Returns the gains of the bins in reach, best first. sides: of the draws.
std::vector<ProbeGain> gainsOf(const Draws& draws, const std::vector<ProbeSide>& sides,
                               const RobotModel& robot, double armSd, const Poll& poll)
{
    if (!(armSd > 0.0) || !std::isfinite(armSd))
        throw std::invalid_argument("probeGains: armSd must be finite and above 0 m");
    const Uncertainty before = uncertaintyOf(draws, poll);
    std::vector<ProbeGain> gains;
    for (int bin = 0; bin < kBins; ++bin)
        for (std::size_t side = 0; side < sides.size(); ++side) {
            if (!robot.armReaches(bin, sides[side])) continue;
            const ProbeGain after = expectedAfter(draws, side, bin, armSd, poll);
            gains.push_back({bin, before.variance - after.varianceReduction,
                             before.entropy - after.entropyReduction, sides[side]});
        }
    std::stable_sort(gains.begin(), gains.end(), [](const ProbeGain& a, const ProbeGain& b) {
        return a.varianceReduction > b.varianceReduction;
    });
    return gains;
}

}  // namespace

Uncertainty uncertainty(const TerrainEstimate& estimate, double stepLimit, int firstBin,
                        const Poll& poll)
{
    return uncertaintyOf(drawsOf({&estimate.draws}, stepLimit, firstBin, poll), poll);
}

Uncertainty uncertainty(const TwoTrackEstimate& estimate, double stepLimit, int firstBin,
                        const Poll& poll)
{
    if (estimate.onePlane) return uncertainty(estimate.side[0], stepLimit, firstBin, poll);
    return uncertaintyOf(drawsOf(bothOf(estimate), stepLimit, firstBin, poll), poll);
}

std::vector<ProbeGain> probeGains(const TerrainEstimate& estimate, const RobotModel& robot,
                                  double armSd, double stepLimit, int firstBin, const Poll& poll)
{
    return gainsOf(drawsOf({&estimate.draws}, stepLimit, firstBin, poll), {ProbeSide::Middle},
                   robot, armSd, poll);
}

std::vector<ProbeGain> probeGains(const TwoTrackEstimate& estimate, const RobotModel& robot,
                                  double armSd, double stepLimit, int firstBin, const Poll& poll)
{
    if (estimate.onePlane)
        return probeGains(estimate.side[0], robot, armSd, stepLimit, firstBin, poll);
    return gainsOf(drawsOf(bothOf(estimate), stepLimit, firstBin, poll),
                   {ProbeSide::Left, ProbeSide::Right}, robot, armSd, poll);
}

std::optional<ProbeGain> bestProbe(const TerrainEstimate& estimate, const RobotModel& robot,
                                   double armSd, double stepLimit)
{
    for (const ProbeGain& gain : probeGains(estimate, robot, armSd, stepLimit))
        if (estimate.origin[static_cast<std::size_t>(gain.bin)] == Origin::Sampled) return gain;
    return std::nullopt;
}

}  // namespace terratact
