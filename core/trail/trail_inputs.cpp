#include "core/trail/trail_inputs.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/learn/data/columns.h"
#include "core/learn/data/side_features.h"
#include "core/learn/model/surface_rows.h"

namespace terratact {
namespace {

constexpr double kLoadScale = 3.0;  // [N]

/// Appends numbers to a vector of known size.
class Appended {
public:
    explicit Appended(Eigen::Index size) : values_(size) {}
    void add(double value) { values_[next_++] = value; }
    void add(std::span<const double> values)
    {
        for (const double value : values) add(value);
    }
    Eigen::VectorXd take()
    {
        if (next_ != values_.size()) throw std::logic_error("inputs of another size");
        return std::move(values_);
    }

private:
    Eigen::VectorXd values_;
    Eigen::Index next_ = 0;
};

double clearanceInput(double ceiling, double height)
{
    return std::asinh((ceiling - height) / kTrailClearance);
}

void addGround(Appended& inputs, const TrailGround& ground, const TrailHistory& history,
               const Heights& ceiling)
{
    std::array<double, kTrailBins> top{};
    for (std::size_t i = 0; i < kTrailBins; ++i)
        top[i] = std::isfinite(ceiling[i]) ? ceiling[i] : kTrailOpenCeiling;
    for (std::size_t i = 0; i < kTrailBins; ++i)
        inputs.add(clearanceInput(top[i], std::min(ground.lowest[i], top[i])));
    for (const double load : ground.load) inputs.add(std::log1p(load / kLoadScale));
    for (std::size_t i = 0; i < kTrailBins; ++i)
        inputs.add(ground.load[i] > 0.0 ? clearanceInput(top[i], ground.pressed[i]) : 0.0);
    inputs.add(history.way);
    for (const double height : ceiling) inputs.add(std::isfinite(height) ? 0.0 : 1.0);
}

std::span<const double> numbers(const Eigen::VectorXd& values)
{
    return {values.data(), static_cast<std::size_t>(values.size())};
}

}  // namespace

Eigen::VectorXd planeInputs(const Proprioception& s, const TrailHistory& history,
                            const Heights& ceiling)
{
    if (missingFeatures(s).any()) throw std::invalid_argument("a feature of s is unknown");
    const FeatureValues values = featureValues(s);
    Eigen::VectorXd raw(Eigen::Index{kFeatures});
    for (std::size_t d = 0; d < kFeatures; ++d) raw[static_cast<Eigen::Index>(d)] = *values[d];
    Appended inputs(kPlaneInputs);
    inputs.add(numbers(surfaceFeatures(raw)));
    inputs.add(history.pitch);
    addGround(inputs, history.ground[0], history, ceiling);
    return inputs.take();
}

Eigen::VectorXd sideInputs(const TwoTrackReadings& s, Side own, const TrailHistory& history,
                           const Heights& ceiling)
{
    if (absentFeatures(s, own).any()) throw std::invalid_argument("a feature of a side is unknown");
    Appended inputs(kSideInputs);
    inputs.add(numbers(surfaceFeatures(sideFeatures(s, own))));
    inputs.add(history.pitch);
    for (const double roll : history.roll) inputs.add(signOf(own) * roll);
    addGround(inputs, history.ground[own == Side::Left ? 1 : 2], history, ceiling);
    return inputs.take();
}

}  // namespace terratact
