#include "app/modelling/truth/truth_file.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include "app/modelling/truth/truth_cells.h"
#include "core/base/named.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sqlite.h"
#include "core/store/sqlite_tables.h"

namespace terratact {
namespace {

constexpr std::int64_t kTruthVersion = 2;
constexpr std::uintmax_t kMaxTruthBytes = std::uintmax_t{1} << 30U;
constexpr std::size_t kMaxTruthRobotBytes = std::size_t{64} * 1024;
constexpr double kMillimetre = 1e-3;
constexpr std::size_t kMaxSlicePoints = 40'000;
constexpr double kMaxRule = 100.0;      // of a percentile and of every sd [m]
constexpr double kMaxCorrection = 1e3;  // [m], slope
constexpr double kMaxRoll = 3.2;        // [rad]

static_assert(std::endian::native == std::endian::little,
              "slices are stored as they lie in memory");

constexpr auto kGapNames =
    namesOf<TruthGap>("none", "other run", "no pose", "off cloud", "no cloud", "excluded");

/// A point as the first version stores it [mm].
struct StoredPoint {
    std::int16_t line = 0, x = 0, z = 0;
};
static_assert(sizeof(StoredPoint) == 6);

/// Refusal of a truth file: a sentence without the file's name.
class TruthRefused : public Failure {
public:
    using Failure::Failure;
};

void requireTruth(bool holds, const Message& cause)
{
    if (!holds) throw TruthRefused{cause};
}

constexpr const char* kMetaTable =
    "CREATE TABLE meta(key TEXT NOT NULL, value TEXT NOT NULL) STRICT";

const std::vector<SqliteTable>& truthSchema()
{
    static const std::vector<SqliteTable> tables{
        {"meta", kMetaTable},
        {"rule", "CREATE TABLE rule(percentile REAL NOT NULL, max_sd_m REAL NOT NULL, "
                 "own_margin_m REAL NOT NULL, place_sd_m REAL NOT NULL) STRICT"},
        {"scene",
         "CREATE TABLE scene(number INTEGER PRIMARY KEY, csv TEXT NOT NULL, gap TEXT NOT NULL, "
         "cloud_m REAL, roll_rad REAL NOT NULL, offset_m REAL NOT NULL, tilt_x REAL NOT NULL, "
         "tilt_y REAL NOT NULL, cells BLOB NOT NULL) STRICT"}};
    return tables;
}

/// Tables of the first version.
const std::vector<SqliteTable>& firstTruthSchema()
{
    static const std::vector<SqliteTable> tables{
        {"meta", kMetaTable},
        {"scene",
         "CREATE TABLE scene(number INTEGER PRIMARY KEY, csv TEXT NOT NULL, gap TEXT NOT NULL, "
         "cloud_m REAL, slice BLOB NOT NULL) STRICT"}};
    return tables;
}

std::vector<SlicePoint> sliceOf(const std::string& bytes)
{
    requireTruth(bytes.size() % sizeof(StoredPoint) == 0
                     && bytes.size() <= kMaxSlicePoints * sizeof(StoredPoint),
                 TR_NOOP("core", "the slice of a scene is damaged: write the file again"));
    std::vector<StoredPoint> points(bytes.size() / sizeof(StoredPoint));
    if (!points.empty()) std::memcpy(points.data(), bytes.data(), bytes.size());
    std::vector<SlicePoint> slice;
    slice.reserve(points.size());
    for (const StoredPoint& p : points) {
        requireTruth(p.line >= 0 && p.line < static_cast<int>(kTruthLines),
                     TR_NOOP("core", "the slice of a scene is damaged: write the file again"));
        slice.push_back({static_cast<TruthLine>(p.line), kMillimetre * p.x, kMillimetre * p.z});
    }
    return slice;
}

void insertMeta(SqliteFile& file, const char* key, const std::string& value)
{
    SqliteStatement row = file.prepare("INSERT INTO meta VALUES(?, ?)");
    row.bind(0, key);
    row.bind(1, std::string_view(value));
    row.run();
}

void insertScenes(SqliteFile& file, const LaserTruth& truth)
{
    SqliteStatement row = file.prepare("INSERT INTO scene VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < truth.scenes(); ++i) {
        const SceneTruth& scene = truth.truths[i];
        row.bind(0, static_cast<std::int64_t>(i + 1));
        row.bind(1, std::string_view(truth.isPlane ? scenesText({truth.plane[i]})
                                                   : twoTrackScenesText({truth.tracks[i]})));
        row.bind(2, nameIn(kGapNames, scene.gap));
        if (scene.contact)
            row.bind(3, -scene.contact->offset);
        else
            row.bind(3, nullptr);
        const bool hasCells = truth.grid && scene.hasPlace();
        row.bind(4, hasCells ? truth.grid->places()[scene.place].s.roll : truth.tracks[i].s.roll);
        row.bind(5, scene.correction.offset);
        row.bind(6, scene.correction.tiltX);
        row.bind(7, scene.correction.tiltY);
        row.bindBlob(8, hasCells ? storedCells(truth.grid->cellsOf(scene.place)) : std::string());
        row.run();
    }
}

void insertRule(SqliteFile& file, const TruthRule& rule)
{
    SqliteStatement row = file.prepare("INSERT INTO rule VALUES(?, ?, ?, ?)");
    row.bind(0, rule.percentile);
    row.bind(1, rule.maxSd);
    row.bind(2, rule.ownMargin);
    row.bind(3, rule.placeSd);
    row.run();
}

void fillTruthFile(const std::string& path, const LaserTruth& truth, const std::string& robot)
{
    SqliteFile file = SqliteFile::fill(path);
    file.run("PRAGMA page_size = 4096");
    file.run("PRAGMA application_id = " + std::to_string(kTruthApplicationId));
    file.run("PRAGMA user_version = " + std::to_string(kTruthVersion));
    for (const SqliteTable& table : truthSchema()) file.run(table.sql);
    file.run("BEGIN");
    insertMeta(file, "robot", robot);
    insertMeta(file, "kind", truth.isPlane ? "plane" : "tracks");
    insertRule(file, truth.rule);
    insertScenes(file, truth);
    file.run("COMMIT");
    file.close();
}

/// Puts heights and sds of a scene where laserTruth() has them.
SideTruth binsOf(const OptionalHeights& heights, const OptionalHeights& sds)
{
    SideTruth bins{};
    for (std::size_t i = 0; i < kBins; ++i) {
        bins.at(i).height = heights.at(i);
        bins.at(i).sd = sds.at(i).value_or(0.0);
    }
    return bins;
}

void addTruthScene(LaserTruth& truth, const std::string& csv, std::size_t number)
{
    auto reader = CsvReader::over(fmt::format("scene {}", number), csv);
    if (!reader) throw TruthRefused{reader.error().message};
    SceneTruth bins;
    const auto single = [&](const auto& file) {
        if (!file) throw TruthRefused{file.error().message};
        requireTruth(file->scenes.size() == 1,
                     {TR_NOOP("core", "scene %1 is not one line of a scenes file"), number});
    };
    if (truth.isPlane) {
        const auto file = readScenes(*std::move(reader));
        single(file);
        truth.plane.push_back(file->scenes.front());
        truth.tracks.push_back(onBothSides(file->scenes).front());
        bins.plane = binsOf(truth.plane.back().truth, truth.plane.back().truthSd);
    } else {
        const auto file = readTwoTrackScenes(*std::move(reader));
        single(file);
        truth.tracks.push_back(file->scenes.front());
        for (std::size_t side = 0; side < 2; ++side)
            bins.side.at(side) =
                binsOf(truth.tracks.back().truth.at(side), truth.tracks.back().truthSd.at(side));
    }
    truth.truths.push_back(bins);
}

void readTruthScenes(SqliteFile& file, LaserTruth& truth)
{
    SqliteStatement row =
        file.prepare("SELECT number, csv, gap, cloud_m FROM scene ORDER BY number");
    while (row.step()) {
        const std::size_t number = truth.scenes() + 1;
        requireTruth(row.integer(0) == static_cast<std::int64_t>(number),
                     {TR_NOOP("core", "scene %1 is missing: write the file again"), number});
        requireTruth(number <= kMaxTruthScenes,
                     {TR_NOOP("core", "has more than %1 scenes"), kMaxTruthScenes});
        addTruthScene(truth, row.text(1), number);
        const auto gap = valueIn<TruthGap>(kGapNames, row.text(2));
        requireTruth(gap.has_value(),
                     {TR_NOOP("core", "scene %1: why it has no heights is unknown"), number});
        truth.truths.back().gap = *gap;
        if (row.isNull(3)) continue;
        requireTruth(
            std::isfinite(row.real(3)),
            {TR_NOOP("core", "scene %1: its distance to the cloud is not a number"), number});
        truth.truths.back().contact = CloudCorrection{.offset = -row.real(3)};
    }
    requireTruth(truth.scenes() > 0, TR_NOOP("core", "has no scenes"));
}

/// Runs an action on a truth file; what SQLite or the file refuses becomes an error that names it.
template <class Action>
Status onTruthFile(const std::string& path, const Action& action)
{
    try {
        action();
    } catch (const TruthRefused& why) {
        return fileError(path, why.message());
    } catch (const SqliteError& why) {
        return fileError(path, why.message());
    }
    return Done{};
}

}  // namespace

Result<NewFile> newTruthFile(const std::string& path, const LaserTruth& truth,
                             const std::string& robotFile)
{
    if (truth.scenes() > kMaxTruthScenes)
        return fileError(path, Message(TR_NOOP("core", "would hold %1 scenes; expected at most %2: "
                                                       "take fewer scenes, or leave out --review"),
                                       truth.scenes(), kMaxTruthScenes));
    const auto robot = readFile(robotFile, kMaxTruthRobotBytes);
    if (!robot) return robot.error();
    auto file = NewFile::begin(path);
    if (!file) return file.error();
    if (Status done =
            onTruthFile(path, [&] { fillTruthFile(file->temporaryPath(), truth, *robot); });
        !done)
        return done.error();
    return file;
}

TruthFile::TruthFile(std::string path, SqliteFile file)
    : path_(std::move(path)), file_(std::make_unique<SqliteFile>(std::move(file)))
{
}
TruthFile::TruthFile(TruthFile&& other) noexcept = default;
TruthFile& TruthFile::operator=(TruthFile&& other) noexcept = default;
TruthFile::~TruthFile() = default;

void TruthFile::read()
{
    requireTruth(file_->integer("PRAGMA application_id") == kTruthApplicationId,
                 TR_NOOP("core", "is not a truth file: terratact truth --review writes one"));
    version_ = file_->integer("PRAGMA user_version");
    requireTruth(
        version_ == kTruthVersion || version_ == 1,
        TR_NOOP("core",
                "is a truth file of another version: write it again by terratact truth --review"));
    requireTruth(hasOnlyTables(*file_, hasCells() ? truthSchema() : firstTruthSchema()),
                 TR_NOOP("core", "is a damaged truth file: write it again"));
    std::map<std::string, std::string> meta;
    SqliteStatement row = file_->prepare("SELECT key, value FROM meta");
    while (row.step() && meta.size() < 2) meta.emplace(row.text(0), row.text(1));
    requireTruth(meta.contains("robot") && (meta["kind"] == "plane" || meta["kind"] == "tracks"),
                 TR_NOOP("core", "is a damaged truth file: write it again"));
    auto robot = robotModelFrom("robot", meta["robot"]);
    if (!robot) throw TruthRefused{robot.error().message};
    truth_.robot = *std::move(robot);
    truth_.isPlane = meta["kind"] == "plane";
    file_->grantSteps();
    readTruthScenes(*file_, truth_);
    if (!hasCells()) return;
    readRule();
    readCorrections();
}

void TruthFile::readRule()
{
    SqliteStatement row =
        file_->prepare("SELECT percentile, max_sd_m, own_margin_m, place_sd_m FROM rule");
    requireTruth(row.step(), TR_NOOP("core", "is a damaged truth file: write it again"));
    const auto number = [&](int column) {
        const double value = row.real(column);
        requireTruth(std::isfinite(value) && value >= 0.0 && value <= kMaxRule,
                     TR_NOOP("core", "is a damaged truth file: write it again"));
        return value;
    };
    truth_.rule = {
        .percentile = number(0), .maxSd = number(1), .ownMargin = number(2), .placeSd = number(3)};
}

void TruthFile::readCorrections()
{
    SqliteStatement row =
        file_->prepare("SELECT offset_m, tilt_x, tilt_y FROM scene ORDER BY number");
    for (SceneTruth& scene : truth_.truths) {
        requireTruth(row.step(), TR_NOOP("core", "is a damaged truth file: write it again"));
        scene.correction = {row.real(0), row.real(1), row.real(2)};
        for (const double value :
             {scene.correction.offset, scene.correction.tiltX, scene.correction.tiltY})
            requireTruth(std::abs(value) <= kMaxCorrection,
                         TR_NOOP("core", "is a damaged truth file: write it again"));
    }
}

Result<TruthFile> TruthFile::open(const std::string& path)
{
    std::optional<TruthFile> opened;
    if (Status done = onTruthFile(path,
                                  [&] {
                                      opened.emplace(TruthFile(
                                          path, SqliteFile::openUntrusted(path, kMaxTruthBytes)));
                                      opened->read();
                                  });
        !done)
        return done.error();
    return *std::move(opened);
}

Result<std::vector<SlicePoint>> TruthFile::slice(std::size_t row)
{
    std::vector<SlicePoint> slice;
    const auto read = [&] {
        if (!hasCells())
            slice = storedSlice(row);
        else if (row >= truth_.scenes() || truth_.truths[row].hasPlace()) {
            const SceneGrid grid = gridOf(row);
            slice = truthSlice(grid, truth_.robot, 0, truth_.truths[row].correction);
        }
    };
    if (Status done = onTruthFile(path_, read); !done) return done.error();
    return slice;
}

std::vector<SlicePoint> TruthFile::storedSlice(std::size_t row)
{
    file_->grantSteps();
    SqliteStatement found = file_->prepare("SELECT slice FROM scene WHERE number = ?");
    found.bind(0, static_cast<std::int64_t>(row + 1));
    requireTruth(found.step(),
                 {TR_NOOP("core", "scene %1 is missing: write the file again"), row + 1});
    return sliceOf(found.blob(0));
}

SceneGrid TruthFile::gridOf(std::size_t row)
{
    requireTruth(hasCells(), TR_NOOP("core", "was written by an earlier version and holds no cells "
                                             "of the cloud: write it again by terratact truth "
                                             "--review to nudge along the way"));
    file_->grantSteps();
    SqliteStatement found = file_->prepare("SELECT roll_rad, cells FROM scene WHERE number = ?");
    found.bind(0, static_cast<std::int64_t>(row + 1));
    requireTruth(found.step(),
                 {TR_NOOP("core", "scene %1 is missing: write the file again"), row + 1});
    const auto cells = cellsFrom(found.blob(1));
    const Message damaged(
        TR_NOOP("core", "the cells of scene %1 are damaged: write the file again"), row + 1);
    requireTruth(cells.has_value() && std::abs(found.real(0)) <= kMaxRoll, damaged);
    ScenePlace place{.row = row, .s = truth_.tracks.at(row).s};
    place.s.roll = found.real(0);
    auto grid = SceneGrid::restored(truth_.robot, std::move(place), *cells);
    requireTruth(static_cast<bool>(grid), damaged);
    return *std::move(grid);
}

Result<SceneGrid> TruthFile::grid(std::size_t row)
{
    std::optional<SceneGrid> grid;
    if (Status done = onTruthFile(path_, [&] { grid.emplace(gridOf(row)); }); !done)
        return done.error();
    return *std::move(grid);
}

}  // namespace terratact
