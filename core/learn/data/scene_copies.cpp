#include "core/learn/data/scene_copies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/learn/data/columns.h"
#include "core/learn/data/side_features.h"

namespace terratact {

namespace {

// Noise as in core/sim/sensor_noise.h.
constexpr double kPitchSd = 0.0087, kAngleSd = 0.0017;   // [rad]
constexpr double kCurrentSd = 0.05;                      // [A]
constexpr double kForceShare = 0.10, kForceFloor = 0.3;  // share, [N]
constexpr double kMaxHeightDifference = 0.026;           // [m] root mean square

/// Features and heights of a scene of one plane, which determine its place.
struct PlaneKey {
    static constexpr std::size_t kAngle = 1;  ///< the front flippers' feature
    static double noise(std::size_t feature, double value)
    {
        if (feature == 0) return kPitchSd;
        if (feature < kFrontCurrentFeature) return kAngleSd;
        if (feature < kFirstForceFeature) return kCurrentSd;
        return std::hypot(kForceShare * value, kForceFloor);
    }
    std::array<double, kFeatures> features{};
    std::array<double, kBins> heights{};  ///< NaN where a height is unknown
};

/// The same of two tracks: features of the left side, and heights of left and right.
struct TracksKey {
    static constexpr std::size_t kAngle = 2;
    static double noise(std::size_t feature, double value)
    {
        if (feature < kAngle) return kPitchSd;  // pitch and roll
        if (feature < kFirstSideCurrent) return kAngleSd;
        if (feature < kFirstSideForce) return kCurrentSd;
        return std::hypot(kForceShare * value, kForceFloor);
    }
    std::array<double, kSideFeatures> features{};
    std::array<double, std::size_t{2} * kBins> heights{};
};

constexpr double kUnknownHeight = std::numeric_limits<double>::quiet_NaN();

PlaneKey keyOf(const Scene& scene)
{
    PlaneKey key;
    const FeatureValues values = featureValues(scene.s);
    for (std::size_t d = 0; d < kFeatures; ++d) key.features[d] = values[d].value_or(0.0);
    for (std::size_t i = 0; i < kBins; ++i)
        key.heights[i] = scene.truth[i].value_or(kUnknownHeight);
    return key;
}

TracksKey keyOf(const TwoTrackScene& scene)
{
    TracksKey key;
    Eigen::Map<Eigen::VectorXd>(key.features.data(), Eigen::Index{kSideFeatures}) =
        sideFeatures(scene.s, Side::Left);
    for (std::size_t i = 0; i < key.heights.size(); ++i)
        key.heights[i] = scene.truth[i / kBins][i % kBins].value_or(kUnknownHeight);
    return key;
}

/// Returns true for the same readings, except for digits that a number format dropped.
template <class Key>
bool isRewritten(const Key& a, const Key& b)
{
    double sum = 0.0;
    for (std::size_t d = 0; d < a.features.size(); ++d) {
        const double sd = Key::noise(d, std::max(a.features[d], b.features[d]));
        const double off = std::abs(a.features[d] - b.features[d]) / sd;
        if (!(off <= kRewrittenSd)) return false;
        sum += off * off;
    }
    return std::sqrt(sum / static_cast<double>(a.features.size())) <= kRewrittenRms;
}

template <class Key>
bool isExactCopy(const Key& a, const Key& b)
{
    for (std::size_t i = 0; i < a.heights.size(); ++i)
        if (std::isnan(a.heights[i]) != std::isnan(b.heights[i])
            || std::abs(a.heights[i] - b.heights[i]) > kRewrittenHeight)
            return false;
    return isRewritten(a, b);
}

template <class Key>
bool repeats(const Key& a, const Key& b)
{
    for (std::size_t d = 0; d < a.features.size(); ++d) {
        const double sd = Key::noise(d, std::max(a.features[d], b.features[d]));
        if (std::abs(a.features[d] - b.features[d]) > kCopySd * std::numbers::sqrt2 * sd)
            return false;
    }
    double sum = 0.0;
    int common = 0;
    for (std::size_t i = 0; i < a.heights.size(); ++i) {
        if (std::isnan(a.heights[i]) || std::isnan(b.heights[i])) continue;
        sum += std::pow(a.heights[i] - b.heights[i], 2.0);
        ++common;
    }
    return common > 0 && std::sqrt(sum / common) <= kMaxHeightDifference;
}

/// Heights of one side and their least-squares line.
class HeightLine {
public:
    /// x: number of the bin. z: height [m].
    void add(double x, double z)
    {
        ++n_;
        const double dx = x - meanX_, dz = z - meanZ_;
        meanX_ += dx / n_;
        meanZ_ += dz / n_;
        xx_ += dx * (x - meanX_);
        xz_ += dx * (z - meanZ_);
        zz_ += dz * (z - meanZ_);
    }
    /// Returns the sum of squares of the heights about the line [m²].
    double squares() const { return n_ > 2 ? std::max(zz_ - xz_ * xz_ / xx_, 0.0) : 0.0; }

private:
    int n_ = 0;
    double meanX_ = 0.0, meanZ_ = 0.0, xx_ = 0.0, xz_ = 0.0, zz_ = 0.0;
};

/// Returns true if the ground itself shows that both scenes have one place (kSameGround).
template <class Key>
bool sharesGround(const Key& a, const Key& b)
{
    double difference = 0.0, uneven = 0.0;
    for (std::size_t side = 0; side < a.heights.size(); side += kBins) {
        HeightLine line;
        for (std::size_t i = 0; i < kBins; ++i) {
            const double z = a.heights[side + i], off = z - b.heights[side + i];
            if (std::isnan(off)) continue;
            difference += off * off + kRewrittenHeight * kRewrittenHeight;
            line.add(static_cast<double>(i), z);
        }
        uneven += line.squares();
    }
    return difference < kSameGround * kSameGround * uneven;
}

/// Scenes sorted by the front flippers' angle, which hardly differs between copies.
template <class Key>
class ByAngle {
public:
    void add(const Key& key, int number)
    {
        known_.emplace(key.features[Key::kAngle], Entry{key, number});
    }

    /// Returns the least number of the scenes within `reach` [rad] that satisfy is(known).
    template <class Is>
    std::optional<int> first(const Key& key, double reach, Is is) const
    {
        std::optional<int> least;
        const double angle = key.features[Key::kAngle];
        const auto last = known_.upper_bound(angle + reach);
        for (auto known = known_.lower_bound(angle - reach); known != last; ++known)
            if (const Entry& other = known->second; !least || other.number < *least)
                if (is(other.key)) least = other.number;
        return least;
    }
    bool hasExactCopyOf(const Key& key) const
    {
        return first(key, kRewrittenSd * kAngleSd,
                     [&key](const Key& other) { return isExactCopy(other, key); })
            .has_value();
    }

private:
    struct Entry {
        Key key;
        int number;
    };
    std::multimap<double, Entry> known_;
};

/// First scene of each place, with its number.
template <class Key>
class Places {
public:
    /// Returns the place of a known scene that this one repeats; empty: none.
    std::optional<int> known(const Key& key) const
    {
        return first_.first(key, kCopySd * std::numbers::sqrt2 * kAngleSd,
                            [&key](const Key& other) { return repeats(other, key); });
    }
    void add(const Key& key, int number) { first_.add(key, number); }
    /// Returns the number of the scene's place: its own number if it is the first scene there.
    int placeOf(const Key& key, int number)
    {
        if (const auto place = known(key)) return *place;
        add(key, number);
        return number;
    }

private:
    ByAngle<Key> first_;
};

/// Returns the keys of a scene and of its mirror image.
std::array<PlaneKey, 1> keysOf(const Scene& scene)
{
    return {keyOf(scene)};
}
std::array<TracksKey, 2> keysOf(const TwoTrackScene& scene)
{
    return {keyOf(scene), keyOf(mirrored(scene))};
}

bool hasFeatures(const Scene& scene)
{
    return missingFeatures(scene.s).none();
}
bool hasFeatures(const TwoTrackScene& scene)
{
    return absentFeatures(scene.s, Side::Left).none();
}

/// Returns the key of a training row. Of two tracks, rows 2k and 2k + 1 are both sides of a scene.
template <class Key>
Key keyOfRow(const Eigen::MatrixXd& features, const Eigen::MatrixXd& heights,
             const std::vector<unsigned>& unknownBins, Eigen::Index u)
{
    Key key;
    for (std::size_t d = 0; d < key.features.size(); ++d)
        key.features[d] = features(u, static_cast<Eigen::Index>(d));
    for (std::size_t i = 0; i < key.heights.size(); ++i) {
        const Eigen::Index row = u ^ static_cast<Eigen::Index>(i / kBins);
        const std::size_t bin = i % kBins;
        const unsigned unknown =
            unknownBins.empty() ? 0 : unknownBins[static_cast<std::size_t>(row)];
        key.heights[i] = (unknown >> bin & 1U) != 0 ? kUnknownHeight
                                                    : heights(row, static_cast<Eigen::Index>(bin));
    }
    return key;
}

bool knowsAnyHeight(const Scene& scene)
{
    return knowsHeights(scene.truth);
}
bool knowsAnyHeight(const TwoTrackScene& scene)
{
    return knowsHeights(scene.truth[0]) || knowsHeights(scene.truth[1]);
}

}  // namespace

bool isNearCopy(const Scene& a, const Scene& b)
{
    return repeats(keyOf(a), keyOf(b));
}

template <class SceneType>
struct SceneRepeats<SceneType>::Known {
    using Key = decltype(keyOf(std::declval<SceneType>()));
    ByAngle<Key> all;
    Places<Key> places;
};

template <class SceneType>
SceneRepeats<SceneType>::SceneRepeats() : known_(std::make_unique<Known>())
{
}

template <class SceneType>
SceneRepeats<SceneType>::~SceneRepeats() = default;

template <class SceneType>
SceneRepeat SceneRepeats<SceneType>::add(const SceneType& scene, int number)
{
    SceneRepeat repeat{number, false};
    if (!hasFeatures(scene) || !knowsAnyHeight(scene)) return repeat;
    const auto keys = keysOf(scene);
    for (const auto& key : keys) {
        repeat.isExact = repeat.isExact || known_->all.hasExactCopyOf(key);
        repeat.first = std::min(repeat.first, known_->places.known(key).value_or(number));
    }
    if (repeat.isExact) return repeat;
    known_->all.add(keys.front(), number);
    if (repeat.first == number) known_->places.add(keys.front(), number);
    return repeat;
}

template class SceneRepeats<Scene>;
template class SceneRepeats<TwoTrackScene>;

SceneCopies withoutCopies(const std::vector<const Scene*>& scenes)
{
    SceneCopies copies;
    SceneRepeats<Scene> known;
    int number = 0;
    for (const Scene* const scene : scenes) {
        const SceneRepeat repeat = known.add(*scene, number);
        if (repeat.isExact) {
            ++copies.exact;
        } else if (repeat.first == number) {
            copies.kept.push_back(scene);
        } else {
            copies.repeats.push_back(scene);
            copies.runs.insert(scene->run);
        }
        ++number;
    }
    return copies;
}

TrackCopies withoutCopies(const std::vector<const TwoTrackScene*>& scenes)
{
    TrackCopies copies;
    SceneRepeats<TwoTrackScene> known;
    int number = 0;
    for (const TwoTrackScene* const scene : scenes) {
        const SceneRepeat repeat = known.add(*scene, number);
        if (repeat.isExact) {
            ++copies.exact;
        } else if (repeat.first == number) {
            copies.kept.push_back(scene);
        } else {
            ++copies.near;
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
    Places<PlaneKey> places;
    std::vector<int> result;
    result.reserve(static_cast<std::size_t>(features.rows()));
    for (Eigen::Index u = 0; u < features.rows(); ++u)
        result.push_back(places.placeOf(keyOfRow<PlaneKey>(features, heights, unknownBins, u),
                                        static_cast<int>(u)));
    return result;
}

namespace {

/// Returns true for a scene that is a training row, or a near copy of one that its ground shows.
template <class Key>
bool wasTrained(const ByAngle<Key>& rows, const Key& key)
{
    return rows
        .first(key, kCopySd * std::numbers::sqrt2 * kAngleSd,
               [&key](const Key& row) {
                   return isRewritten(row, key) || (repeats(row, key) && sharesGround(row, key));
               })
        .has_value();
}

template <class Key, class SceneType>
std::size_t countTrained(const std::vector<SceneType>& scenes, const Eigen::MatrixXd& features,
                         const Eigen::MatrixXd& heights, const std::vector<unsigned>& unknownBins)
{
    ByAngle<Key> rows;
    for (Eigen::Index u = 0; u < features.rows(); ++u)
        rows.add(keyOfRow<Key>(features, heights, unknownBins, u), static_cast<int>(u));
    return static_cast<std::size_t>(std::ranges::count_if(scenes, [&rows](const SceneType& scene) {
        return hasFeatures(scene) && wasTrained(rows, keyOf(scene));
    }));
}

}  // namespace

std::size_t trainingScenes(const std::vector<Scene>& scenes, const Eigen::MatrixXd& features,
                           const Eigen::MatrixXd& heights, const std::vector<unsigned>& unknownBins)
{
    return countTrained<PlaneKey>(scenes, features, heights, unknownBins);
}

std::size_t trainingScenes(const std::vector<TwoTrackScene>& scenes,
                           const Eigen::MatrixXd& features, const Eigen::MatrixXd& heights,
                           const std::vector<unsigned>& unknownBins)
{
    return countTrained<TracksKey>(scenes, features, heights, unknownBins);
}

}  // namespace terratact
