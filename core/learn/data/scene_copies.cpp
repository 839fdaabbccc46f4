#include "core/learn/data/scene_copies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/learn/data/columns.h"

namespace terratact {

namespace {

// Noise as in core/sim/sensor_noise.h.
constexpr double kPitchSd = 0.0087, kAngleSd = 0.0017;   // [rad]
constexpr double kCurrentSd = 0.05;                      // [A]
constexpr double kForceShare = 0.10, kForceFloor = 0.3;  // share, [N]
constexpr std::size_t kFrontFeature = 1;
constexpr double kMaxHeightDifference = 0.026;  // [m] root mean square

double noiseOf(std::size_t feature, double value)
{
    if (feature == 0) return kPitchSd;
    if (feature < kFrontCurrentFeature) return kAngleSd;
    if (feature < kFirstForceFeature) return kCurrentSd;
    return std::hypot(kForceShare * value, kForceFloor);
}

using Key = std::array<double, kFeatures>;

Key keyOf(const Scene& scene)
{
    Key key{};
    const FeatureValues values = featureValues(scene.s);
    for (std::size_t d = 0; d < kFeatures; ++d) key[d] = values[d].value_or(0.0);
    return key;
}

/// Returns true for the same scene, except for digits that a number format dropped.
bool isRewritten(const Key& a, const Key& b)
{
    double sum = 0.0;
    for (std::size_t d = 0; d < kFeatures; ++d) {
        const double off = std::abs(a[d] - b[d]) / noiseOf(d, std::max(a[d], b[d]));
        if (!(off <= kRewrittenSd)) return false;
        sum += off * off;
    }
    return std::sqrt(sum / kFeatures) <= kRewrittenRms;
}

/// Kept scenes, sorted by the front flippers' angle, which hardly differs between near copies.
class Kept {
public:
    explicit Kept(SceneCopies& copies) : copies_(copies) {}

    void take(const Scene& scene)
    {
        const double reach = kCopySd * std::sqrt(2.0) * kAngleSd;
        bool near = false;
        const auto last = byAngle_.upper_bound(scene.s.front + reach);
        for (auto known = byAngle_.lower_bound(scene.s.front - reach); known != last; ++known) {
            const Scene& other = *known->second;
            if (other.truth == scene.truth && keyOf(other) == keyOf(scene)) {
                ++copies_.exact;
                return;
            }
            near = near || isNearCopy(other, scene);
        }
        if (near) {
            ++copies_.near;
            copies_.runs.insert(scene.run);
            return;
        }
        copies_.kept.push_back(&scene);
        byAngle_.emplace(scene.s.front, &scene);
    }

private:
    SceneCopies& copies_;
    std::multimap<double, const Scene*> byAngle_;
};

}  // namespace

bool isNearCopy(const Scene& a, const Scene& b)
{
    const Key first = keyOf(a), second = keyOf(b);
    for (std::size_t d = 0; d < kFeatures; ++d) {
        const double sd = noiseOf(d, std::max(first[d], second[d]));
        if (std::abs(first[d] - second[d]) > kCopySd * std::sqrt(2.0) * sd) return false;
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < kBins; ++i)
        sum += std::pow(a.truth[i].value_or(0.0) - b.truth[i].value_or(0.0), 2.0);
    return std::sqrt(sum / kBins) <= kMaxHeightDifference;
}

SceneCopies withoutCopies(const std::vector<const Scene*>& scenes)
{
    SceneCopies copies;
    Kept kept(copies);
    for (const Scene* const scene : scenes) kept.take(*scene);
    return copies;
}

std::size_t trainingScenes(const std::vector<Scene>& scenes, const Eigen::MatrixXd& features)
{
    std::multimap<double, Key> known;  // by the front flippers' angle
    for (Eigen::Index u = 0; u < features.rows(); ++u) {
        Key key{};
        for (std::size_t d = 0; d < kFeatures; ++d)
            key[d] = features(u, static_cast<Eigen::Index>(d));
        known.emplace(key[kFrontFeature], key);
    }
    const auto isKnown = [&known](const Scene& scene) {
        if (missingFeatures(scene.s).any()) return false;
        const Key key = keyOf(scene);
        const double reach = kRewrittenSd * kAngleSd;
        return std::any_of(known.lower_bound(key[kFrontFeature] - reach),
                           known.upper_bound(key[kFrontFeature] + reach),
                           [&key](const auto& row) { return isRewritten(key, row.second); });
    };
    return static_cast<std::size_t>(std::count_if(scenes.begin(), scenes.end(), isKnown));
}

}  // namespace terratact
