#include "core/eval/contact_sd.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "core/infer/estimate/quantile.h"
#include "core/terrain/kinematic_reconstruction.h"

namespace terratact {
namespace {

constexpr double kMadToSd = 1.4826;  // 1 / Φ⁻¹(3/4)

/// Returns the residuals of one bin, or of all bins if bin < 0.
std::vector<double> valuesOf(std::span<const ContactResidual> residuals, int bin)
{
    std::vector<double> values;
    for (const ContactResidual& r : residuals)
        if (bin < 0 || r.bin == bin) values.push_back(r.residual);
    return values;
}

double robustSdOf(std::vector<double> values)
{
    const double median = quantile(values, 0.5);
    for (double& x : values) x = std::abs(x - median);
    return kMadToSd * quantile(std::move(values), 0.5);
}

}  // namespace

std::vector<ContactResidual> contactResiduals(const RobotModel& robot,
                                              std::span<const Scene> scenes, double threshold,
                                              ContactRule rule)
{
    std::vector<ContactResidual> residuals;
    for (const Scene& scene : scenes) {
        const KinematicReconstruction felt =
            reconstructContacts(robot, scene.s, threshold, rule == ContactRule::Isolated);
        for (std::size_t i = 0; i < kBins; ++i)
            if (felt.height[i] && scene.truth[i])
                residuals.push_back({static_cast<int>(i), *scene.truth[i] - *felt.height[i]});
    }
    return residuals;
}

ResidualStatistics residualStatistics(const std::vector<double>& residuals)
{
    ResidualStatistics s;
    s.n = residuals.size();
    if (s.n == 0) return s;
    const auto n = static_cast<double>(s.n);
    s.mean = std::accumulate(residuals.begin(), residuals.end(), 0.0) / n;
    double squares = 0.0;
    for (const double x : residuals) squares += (x - s.mean) * (x - s.mean);
    if (s.n > 1) s.sd = std::sqrt(squares / (n - 1.0));
    s.robustSd = robustSdOf(residuals);
    return s;
}

ContactSummary summariseContacts(std::span<const ContactResidual> residuals)
{
    ContactSummary summary;
    for (int bin = 0; bin < kBins; ++bin)
        summary.bin[static_cast<std::size_t>(bin)] = residualStatistics(valuesOf(residuals, bin));
    summary.all = residualStatistics(valuesOf(residuals, -1));
    return summary;
}

}  // namespace terratact
