#include "core/learn/data/scene_values.h"

#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <string>
#include <utility>

#include "core/learn/data/columns.h"
#include "core/learn/data/scene_file.h"

namespace terratact {
namespace {

constexpr std::array<const char*, kFlippers> kFlipperNames{"front_left", "front_right", "rear_left",
                                                           "rear_right"};
constexpr std::array<const char*, 2> kSideNames{"left", "right"};

// Order of the numbers of a row.
constexpr std::size_t kAngles = 2;  // after pitch and roll
constexpr std::size_t kCurrents = kAngles + kFlippers;
constexpr std::size_t kFrontForces = kCurrents + kFlippers;
constexpr std::size_t kTurn = kFrontForces + std::size_t{2} * kForceElements;

/// Columns of a file of two tracks. Units and ranges are those of one plane's columns.
class TwoTrackColumns {
public:
    TwoTrackColumns()
    {
        const auto features = featureColumns();
        const Column angle = features[0], current = features[kFrontCurrentFeature];
        add("pitch_rad", angle);
        add("roll_rad", angle);
        for (const std::string flipper : kFlipperNames) add(flipper + "_rad", angle);
        for (const std::string flipper : kFlipperNames) add(flipper + "_current_a", current);
        addForces(0);
        addForces(1);
        all_.most = kMaxScenes;
        all_.neverEmpty = kCurrents;
        all_.required = all_.written = kTurn;
        add("differential_rad", angle);
        addForces(2);
        addForces(3);
        for (const std::string side : kSideNames)
            for (const Column& height : heightColumns())
                add(side + "_" + std::string(height.name), height);
        for (const std::string side : kSideNames)
            for (const Column& sd : heightSdColumns()) add(side + "_" + std::string(sd.name), sd);
        all_.heightPrefixes = {"left_h_", "right_h_", "h_", "left_sd_", "right_sd_", "sd_"};
        all_.heightColumns = "left_h_-0.3_m … right_h_+0.7_m";
    }
    const SceneColumns& all() const { return all_; }

private:
    void add(std::string name, Column like)
    {
        names_.push_back(std::move(name));
        like.name = names_.back();
        all_.columns.push_back(like);
    }
    void addForces(std::size_t flipper)
    {
        for (int e = 1; e <= kForceElements; ++e)
            add(std::string(kFlipperNames[flipper]) + "_force_" + std::to_string(e) + "_n",
                featureColumns()[kFirstForceFeature]);
    }

    std::deque<std::string> names_;  ///< their addresses stay
    SceneColumns all_;
};

template <class Values, class From>
From copyTo(Values& values, From from)
{
    for (auto& value : values) value = *from++;
    return from;
}

auto firstValue(const SceneFileRow& row, std::size_t first)
{
    return row.values.begin() + static_cast<std::ptrdiff_t>(first);
}

}  // namespace

const SceneColumns& planeSceneColumns()
{
    static const SceneColumns columns = [] {
        SceneColumns c{.columns = {featureColumns().begin(), featureColumns().end()},
                       .kinds = {},
                       .most = kMaxScenes,
                       .neverEmpty = 3,  // pitch and the flipper angles
                       .required = kFeatures,
                       .written = kFeatures + std::size_t{kBins},
                       .heightPrefixes = {"h_", "sd_"},
                       .heightColumns = "h_-0.3_m … h_+0.0_m … h_+0.7_m"};
        c.columns.insert(c.columns.end(), heightColumns().begin(), heightColumns().end());
        c.columns.insert(c.columns.end(), heightSdColumns().begin(), heightSdColumns().end());
        return c;
    }();
    return columns;
}

const SceneColumns& twoTrackSceneColumns()
{
    static const TwoTrackColumns columns;
    return columns.all();
}

Scene planeSceneOf(const SceneFileRow& row, std::size_t first)
{
    FeatureValues features{};
    Scene scene{.run = row.run, .time = row.time, .s = {}};
    const auto sd = copyTo(scene.truth, copyTo(features, firstValue(row, first)));
    if (sd != row.values.end()) copyTo(scene.truthSd, sd);
    scene.s = proprioception(features);
    return scene;
}

SceneFileRow sceneRow(const Scene& scene)
{
    SceneFileRow row{.run = scene.run, .time = scene.time, .values = {}};
    const FeatureValues features = featureValues(scene.s);
    row.values.assign(features.begin(), features.end());
    row.values.insert(row.values.end(), scene.truth.begin(), scene.truth.end());
    row.values.insert(row.values.end(), scene.truthSd.begin(), scene.truthSd.end());
    return row;
}

TwoTrackScene twoTrackSceneOf(const SceneFileRow& row, std::size_t first)
{
    TwoTrackScene scene{.run = row.run, .time = row.time, .s = {}};
    auto from = firstValue(row, first);
    scene.s.pitch = (from++)->value();
    scene.s.roll = (from++)->value();
    for (double& angle : scene.s.flippers) angle = (from++)->value();
    from = copyTo(scene.s.currents, from);
    from = copyTo(scene.s.forces[0], from);
    from = copyTo(scene.s.forces[1], from);
    scene.s.differential = *from++;
    from = copyTo(scene.s.forces[2], from);
    from = copyTo(scene.s.forces[3], from);
    from = copyTo(scene.truth[0], from);
    from = copyTo(scene.truth[1], from);
    if (from != row.values.end()) copyTo(scene.truthSd[1], copyTo(scene.truthSd[0], from));
    return scene;
}

SceneFileRow sceneRow(const TwoTrackScene& scene)
{
    SceneFileRow row{.run = scene.run, .time = scene.time, .values = {scene.s.pitch, scene.s.roll}};
    const auto add = [&](const auto& values) {
        row.values.insert(row.values.end(), values.begin(), values.end());
    };
    add(scene.s.flippers);
    add(scene.s.currents);
    add(scene.s.forces[0]);
    add(scene.s.forces[1]);
    row.values.push_back(scene.s.differential);
    add(scene.s.forces[2]);
    add(scene.s.forces[3]);
    add(scene.truth[0]);
    add(scene.truth[1]);
    add(scene.truthSd[0]);
    add(scene.truthSd[1]);
    return row;
}

}  // namespace terratact
