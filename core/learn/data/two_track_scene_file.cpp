#include "core/learn/data/two_track_scene_file.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <stdexcept>

#include "core/learn/data/columns.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/scene_rows.h"

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
constexpr std::size_t kRearForces = kTurn + 1;
constexpr std::size_t kHeights = kRearForces + std::size_t{2} * kForceElements;
constexpr std::size_t kNumbers = kHeights + std::size_t{2} * kBins;

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
        all_.neverEmpty = kCurrents;
        all_.required = kTurn;
        add("differential_rad", angle);
        addForces(2);
        addForces(3);
        for (const std::string side : kSideNames)
            for (const Column& height : heightColumns())
                add(side + "_" + std::string(height.name), height);
        all_.heightPrefixes = {"left_h_", "right_h_", "h_"};
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

const SceneColumns& twoTrackColumns()
{
    static const TwoTrackColumns columns;
    return columns.all();
}

template <class Values, class From>
From copyTo(Values& values, From from)
{
    for (auto& value : values) value = *from++;
    return from;
}

TwoTrackScene twoTrackSceneOf(SceneFileRow& row)
{
    TwoTrackScene scene{.run = row.run, .time = row.time, .s = {}, .truth = {}};
    const auto begin = row.values.begin();
    scene.s.pitch = row.values[0].value();
    scene.s.roll = row.values[1].value();
    for (std::size_t i = 0; i < kFlippers; ++i)
        scene.s.flippers[i] = row.values[kAngles + i].value();
    auto from = copyTo(scene.s.currents, begin + kCurrents);
    from = copyTo(scene.s.forces[0], from);
    from = copyTo(scene.s.forces[1], from);
    scene.s.differential = *from++;
    from = copyTo(scene.s.forces[2], from);
    from = copyTo(scene.s.forces[3], from);
    from = copyTo(scene.truth[0], from);
    copyTo(scene.truth[1], from);
    return scene;
}

SceneFileRow twoTrackRowOf(const TwoTrackScene& scene)
{
    SceneFileRow row{scene.run, scene.time, {scene.s.pitch, scene.s.roll}};
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
    return row;
}

}  // namespace

Result<TwoTrackSceneFile> readTwoTrackScenes(const std::string& path)
{
    Result<CsvReader> csv = CsvReader::open(path);
    if (!csv) return csv.error();
    return readTwoTrackScenes(*std::move(csv));
}

Result<TwoTrackSceneFile> readTwoTrackScenes(CsvReader csv)
{
    if (const Result<bool> first = csv.next(); !first) return first.error();
    TwoTrackSceneFile file;
    if (std::ranges::find(csv.fields(), "roll_rad") == csv.fields().end()) {
        Result<SceneFile> plane = readScenesFromHere(std::move(csv));
        if (!plane) return plane.error();
        file.scenes = onBothSides(plane->scenes);
        file.notices = std::move(plane->notices);
        return file;
    }
    auto notices = readSceneRows(csv, twoTrackColumns(), [&](SceneFileRow& row) {
        file.scenes.push_back(twoTrackSceneOf(row));
    });
    if (!notices) return notices.error();
    file.notices = *std::move(notices);
    return file;
}

std::string twoTrackScenesText(const std::vector<TwoTrackScene>& scenes)
{
    if (scenes.size() > kMaxScenes)
        throw std::invalid_argument("writeScenes: more than " + std::to_string(kMaxScenes)
                                    + " scenes, which is what a file may hold");
    SceneColumns columns = twoTrackColumns();
    std::vector<SceneFileRow> rows;
    rows.reserve(scenes.size());
    std::array<bool, kNumbers> used{};
    std::fill_n(used.begin(), columns.required, true);
    for (const TwoTrackScene& scene : scenes) {
        rows.push_back(twoTrackRowOf(scene));
        for (std::size_t i = 0; i < kNumbers; ++i)
            used[i] = used[i] || rows.back().values[i].has_value();
    }
    const auto withoutUnused = [&](auto& values) {
        std::size_t i = 0;
        std::erase_if(values, [&](const auto&) { return !used[i++]; });
    };
    withoutUnused(columns.columns);
    std::string content = sceneHeader(columns);
    for (SceneFileRow& row : rows) {
        withoutUnused(row.values);
        content += sceneLine(columns, row);
    }
    return content;
}

}  // namespace terratact
