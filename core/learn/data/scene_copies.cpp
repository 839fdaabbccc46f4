#include "core/learn/data/scene_copies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>

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

using HeightKey = std::array<double, kBins>;  // NaN where a height is unknown

constexpr double kUnknownHeight = std::numeric_limits<double>::quiet_NaN();

/// Features and heights of a scene, which determine its place.
struct PlaceKey {
    Key features{};
    HeightKey heights{};
};

PlaceKey placeKeyOf(const Scene& scene)
{
    PlaceKey key{keyOf(scene), {}};
    for (std::size_t i = 0; i < kBins; ++i)
        key.heights[i] = scene.truth[i].value_or(kUnknownHeight);
    return key;
}

bool isExactCopy(const PlaceKey& a, const PlaceKey& b)
{
    for (std::size_t i = 0; i < kBins; ++i)
        if (std::isnan(a.heights[i]) != std::isnan(b.heights[i])
            || std::abs(a.heights[i] - b.heights[i]) > kRewrittenHeight)
            return false;
    return isRewritten(a.features, b.features);
}

bool repeats(const PlaceKey& a, const PlaceKey& b)
{
    for (std::size_t d = 0; d < kFeatures; ++d) {
        const double sd = noiseOf(d, std::max(a.features[d], b.features[d]));
        if (std::abs(a.features[d] - b.features[d]) > kCopySd * std::numbers::sqrt2 * sd)
            return false;
    }
    double sum = 0.0;
    int common = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
        if (std::isnan(a.heights[i]) || std::isnan(b.heights[i])) continue;
        sum += std::pow(a.heights[i] - b.heights[i], 2.0);
        ++common;
    }
    return common > 0 && std::sqrt(sum / common) <= kMaxHeightDifference;
}

/// Scenes sorted by the front flippers' angle, which hardly differs between copies.
class ByAngle {
public:
    void add(const PlaceKey& key, int number)
    {
        known_.emplace(key.features[kFrontFeature], Entry{key, number});
    }

    /// Returns the least number of the scenes within `reach` [rad] that satisfy is(known).
    template <class Is>
    std::optional<int> first(const PlaceKey& key, double reach, Is is) const
    {
        std::optional<int> least;
        const double angle = key.features[kFrontFeature];
        const auto last = known_.upper_bound(angle + reach);
        for (auto known = known_.lower_bound(angle - reach); known != last; ++known)
            if (const Entry& other = known->second; !least || other.number < *least)
                if (is(other.key)) least = other.number;
        return least;
    }

private:
    struct Entry {
        PlaceKey key;
        int number;
    };
    std::multimap<double, Entry> known_;
};

/// First scene of each place, with its number.
class Places {
public:
    /// Returns the number of the scene's place: its own number if it is the first scene there.
    int placeOf(const PlaceKey& key, int number)
    {
        const auto known =
            first_.first(key, kCopySd * std::numbers::sqrt2 * kAngleSd,
                         [&key](const PlaceKey& other) { return repeats(other, key); });
        if (known) return *known;
        first_.add(key, number);
        return number;
    }

private:
    ByAngle first_;
};

}  // namespace

bool isNearCopy(const Scene& a, const Scene& b)
{
    return repeats(placeKeyOf(a), placeKeyOf(b));
}

SceneCopies withoutCopies(const std::vector<const Scene*>& scenes)
{
    SceneCopies copies;
    ByAngle all;
    Places places;
    int number = 0;
    for (const Scene* const scene : scenes) {
        const PlaceKey key = placeKeyOf(*scene);
        if (all.first(key, kRewrittenSd * kAngleSd,
                      [&key](const PlaceKey& other) { return isExactCopy(other, key); })) {
            ++copies.exact;
            continue;
        }
        all.add(key, number);
        if (places.placeOf(key, number) == number) {
            copies.kept.push_back(scene);
        } else {
            copies.repeats.push_back(scene);
            copies.runs.insert(scene->run);
        }
        ++number;
    }
    return copies;
}

std::vector<int> placesOf(const Eigen::MatrixXd& features, const Eigen::MatrixXd& heights,
                          const std::vector<unsigned>& unknownBins)
{
    if (features.rows() != heights.rows() || features.cols() != Eigen::Index{kFeatures}
        || heights.cols() != kBins
        || (!unknownBins.empty() && std::ssize(unknownBins) != heights.rows()))
        throw std::invalid_argument("places need eleven features and heights of every row");
    Places places;
    std::vector<int> result;
    for (Eigen::Index u = 0; u < features.rows(); ++u) {
        PlaceKey key;
        for (std::size_t d = 0; d < kFeatures; ++d)
            key.features[d] = features(u, static_cast<Eigen::Index>(d));
        const unsigned unknown = unknownBins.empty() ? 0 : unknownBins[static_cast<std::size_t>(u)];
        for (std::size_t i = 0; i < kBins; ++i)
            key.heights[i] = (unknown >> i & 1U) != 0 ? kUnknownHeight
                                                      : heights(u, static_cast<Eigen::Index>(i));
        result.push_back(places.placeOf(key, static_cast<int>(u)));
    }
    return result;
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
