#include "core/atem/probe_gain.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/infer/verdict/obstacle.h"

namespace terratact {
namespace {

constexpr std::size_t kReadings = 48;

/// Draws of all bins, prepared for V and H.
class Draws {
public:
    Draws(const std::vector<Heights>& heights, double stepLimit, int firstBin, const Poll& poll)
        : heights_(heights)
    {
        PolledWork work(poll);
        Heights mean{};
        for (const Heights& h : heights) {
            work.done(kBins);
            for (std::size_t i = 0; i < kBins; ++i)
                mean[i] += h[i] / static_cast<double>(heights.size());
        }
        centred_.reserve(heights.size());
        step_.reserve(heights.size());
        squares_.reserve(heights.size());
        for (const Heights& draw : heights) {
            work.done(kBins);
            step_.push_back(hasStep(draw, stepLimit, firstBin) ? 1.0 : 0.0);
            Heights& h = centred_.emplace_back(draw);
            double square = 0.0;
            for (std::size_t i = 0; i < kBins; ++i) {
                h[i] -= mean[i];
                square += h[i] * h[i];
            }
            squares_.push_back(square);
        }
    }

    std::size_t count() const { return heights_.size(); }

    /// Returns the height of one bin in every draw [m].
    std::vector<double> of(std::size_t bin, PolledWork& work) const
    {
        std::vector<double> heights;
        heights.reserve(count());
        for (const Heights& h : heights_) {
            work.done();
            heights.push_back(h[bin]);
        }
        return heights;
    }

    /// Returns V(w) [m²]; 0 if one draw has all the weight. Σ w (h − m)² = Σ w h² − m² with m = Σ w
    /// h takes one pass. The heights are centred, so that no relevant digits are lost.
    double variance(const std::vector<double>& weight, PolledWork& work) const
    {
        Heights mean{};
        double alone = 0.0, second = 0.0;
        for (std::size_t d = 0; d < count(); ++d) {
            work.done(1);
            const double w = weight[d];
            if (w == 0.0) continue;
            alone += w * w;
            second += w * squares_[d];
            for (std::size_t i = 0; i < kBins; ++i) mean[i] += w * centred_[d][i];
        }
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
    const std::vector<Heights>& heights_;
    std::vector<Heights> centred_;  // centred on their mean
    std::vector<double> squares_;   // Σ over the bins of a centred draw's squares
    std::vector<double> step_;      // 1 for a draw with a step
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
        z -= armSd * std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * u);
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

/// Returns the mean of V and H over the readings.
ProbeGain expectedAfter(const Draws& draws, int bin, double armSd, const Poll& poll)
{
    PolledWork work(poll);
    const std::vector<double> heights = draws.of(static_cast<std::size_t>(bin), work);
    ProbeGain after{bin, 0.0, 0.0};
    for (const double z : readings(heights, armSd, work)) {
        const std::vector<double> w = weights(heights, z, armSd, work);
        after.varianceReduction += draws.variance(w, work) / kReadings;
        after.entropyReduction += draws.entropy(w, work) / kReadings;
    }
    return after;
}

Draws drawsOf(const TerrainEstimate& estimate, double stepLimit, int firstBin, const Poll& poll)
{
    if (!(stepLimit >= 0.0) || !std::isfinite(stepLimit))
        throw std::invalid_argument("probeGains: stepLimit must be finite and 0 m or more");
    if (firstBin < 0 || firstBin >= kBins - 1)
        throw std::invalid_argument("probeGains: no such pair of bins");
    if (estimate.draws.empty()) throw std::invalid_argument("probeGains: no draws");
    return {estimate.draws, stepLimit, firstBin, poll};
}

Uncertainty uncertaintyOf(const Draws& draws, const Poll& poll)
{
    PolledWork work(poll);
    const std::vector<double> equal = draws.equalWeights();
    return {draws.variance(equal, work), draws.entropy(equal, work)};
}

}  // namespace

Uncertainty uncertainty(const TerrainEstimate& estimate, double stepLimit, int firstBin,
                        const Poll& poll)
{
    return uncertaintyOf(drawsOf(estimate, stepLimit, firstBin, poll), poll);
}

std::vector<ProbeGain> probeGains(const TerrainEstimate& estimate, const RobotModel& robot,
                                  double armSd, double stepLimit, int firstBin, const Poll& poll)
{
    if (!(armSd > 0.0) || !std::isfinite(armSd))
        throw std::invalid_argument("probeGains: armSd must be finite and above 0 m");
    const Draws draws = drawsOf(estimate, stepLimit, firstBin, poll);
    const Uncertainty before = uncertaintyOf(draws, poll);
    std::vector<ProbeGain> gains;
    for (int bin = 0; bin < kBins; ++bin) {
        if (!robot.armReaches(bin)) continue;
        const ProbeGain after = expectedAfter(draws, bin, armSd, poll);
        gains.push_back({bin, before.variance - after.varianceReduction,
                         before.entropy - after.entropyReduction});
    }
    std::stable_sort(gains.begin(), gains.end(), [](const ProbeGain& a, const ProbeGain& b) {
        return a.varianceReduction > b.varianceReduction;
    });
    return gains;
}

std::optional<ProbeGain> bestProbe(const TerrainEstimate& estimate, const RobotModel& robot,
                                   double armSd, double stepLimit)
{
    for (const ProbeGain& gain : probeGains(estimate, robot, armSd, stepLimit))
        if (estimate.origin[static_cast<std::size_t>(gain.bin)] == Origin::Sampled) return gain;
    return std::nullopt;
}

}  // namespace terratact
