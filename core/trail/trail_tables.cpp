#include "core/trail/trail_tables.h"

#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/learn/model/file/model_checks.h"
#include "core/learn/model/file/model_surfaces.h"
#include "core/trail/trail_file.h"

namespace terratact::trail_file {
namespace {

using model_file::insert;
using model_file::Refused;
using model_file::require;

constexpr Eigen::Index kMaxNetworks = 16, kMaxLayers = 8;
constexpr std::int64_t kMaxDrive = 1'000'000'000;

static_assert(std::endian::native == std::endian::little,
              "numbers are stored as they lie in memory");

const std::vector<SqliteTable>& allTables()
{
    static const std::vector<SqliteTable> tables{
        {"drive", "CREATE TABLE drive(kind TEXT NOT NULL, drive INTEGER NOT NULL, scenes BLOB NOT "
                  "NULL) STRICT"},
        {"error",
         "CREATE TABLE error(kind TEXT NOT NULL, scene INTEGER NOT NULL, drive INTEGER NOT NULL, "
         "covered_left INTEGER NOT NULL, covered_right INTEGER NOT NULL, predicted BLOB NOT NULL, "
         "residual BLOB "
         "NOT NULL) STRICT"},
        {"input", "CREATE TABLE input(kind TEXT NOT NULL, position INTEGER NOT NULL, mean REAL NOT "
                  "NULL, sd REAL NOT NULL) STRICT"},
        {"layer",
         "CREATE TABLE layer(kind TEXT NOT NULL, network INTEGER NOT NULL, layer INTEGER NOT "
         "NULL, outputs INTEGER NOT NULL, inputs INTEGER NOT NULL, weight BLOB NOT NULL, bias "
         "BLOB NOT NULL) STRICT"},
        {"meta", "CREATE TABLE meta(key TEXT NOT NULL, value TEXT NOT NULL) STRICT"},
        {"scale",
         "CREATE TABLE scale(kind TEXT NOT NULL, bin INTEGER NOT NULL, covered INTEGER NOT "
         "NULL, mean REAL NOT NULL, sd REAL NOT NULL) STRICT"}};
    return tables;
}

template <class Number>
std::string bytesOf(const Number* numbers, Eigen::Index count)
{
    std::string bytes(static_cast<std::size_t>(count) * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers, bytes.size());
    return bytes;
}

template <class Number>
std::vector<Number> numbersOf(const std::string& bytes, Eigen::Index count)
{
    require(bytes.size() == static_cast<std::size_t>(count) * sizeof(Number),
            TR_NOOP("core", "a table holds numbers of another size"));
    std::vector<Number> numbers(static_cast<std::size_t>(count));
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

std::string stepsOf(const Eigen::VectorXf& values)
{
    std::vector<std::int16_t> steps;
    steps.reserve(static_cast<std::size_t>(values.size()));
    for (const float value : values) steps.push_back(errorSteps(value));
    return bytesOf(steps.data(), values.size());
}

Eigen::VectorXf valuesOf(const std::string& bytes, Eigen::Index count)
{
    const std::vector<std::int16_t> steps = numbersOf<std::int16_t>(bytes, count);
    Eigen::VectorXf values(count);
    for (Eigen::Index i = 0; i < count; ++i)
        values[i] = errorOfSteps(steps[static_cast<std::size_t>(i)]);
    return values;
}

const auto& scalesOf(const TrailNetworks& networks, bool covered)
{
    return covered ? networks.covered : networks.open;
}

/// Returns the networks in the file's order: that of the errors' size is the last one.
std::vector<const Network*> allOf(const TrailNetworks& networks)
{
    std::vector<const Network*> all;
    all.reserve(networks.networks.size() + 1);
    for (const Network& network : networks.networks) all.push_back(&network);
    if (!networks.isEmpty()) all.push_back(&networks.size);
    return all;
}

void writeLayers(SqliteFile& file, const Kind& kind, const TrailNetworks& networks)
{
    SqliteStatement row = file.prepare("INSERT INTO layer VALUES(?, ?, ?, ?, ?, ?, ?)");
    const std::vector<const Network*> all = allOf(networks);
    for (std::size_t n = 0; n < all.size(); ++n)
        for (std::size_t k = 0; k < all[n]->layers.size(); ++k) {
            const NetworkLayer& layer = all[n]->layers[k];
            row.bind(0, kind.name);
            row.bind(1, static_cast<std::int64_t>(n));
            row.bind(2, static_cast<std::int64_t>(k));
            row.bind(3, std::int64_t{layer.weight.rows()});
            row.bind(4, std::int64_t{layer.weight.cols()});
            row.bindBlob(5, bytesOf(layer.weight.data(), layer.weight.size()));
            row.bindBlob(6, bytesOf(layer.bias.data(), layer.bias.size()));
            row.run();
        }
}

void writeErrors(SqliteFile& file, const Kind& kind, const TrailErrors& errors)
{
    SqliteStatement error = file.prepare("INSERT INTO error VALUES(?, ?, ?, ?, ?, ?, ?)");
    for (Eigen::Index u = 0; u < errors.predicted.cols(); ++u) {
        const auto& covered = errors.covered[static_cast<std::size_t>(u)];
        error.bind(0, kind.name);
        error.bind(1, std::int64_t{u});
        error.bind(2, std::int64_t{errors.drive[static_cast<std::size_t>(u)]});
        error.bind(3, std::int64_t{covered[0]});
        error.bind(4, std::int64_t{covered[1]});
        error.bindBlob(5, stepsOf(errors.predicted.col(u)));
        error.bindBlob(6, stepsOf(errors.residual.col(u)));
        error.run();
    }
}

void writeDrives(SqliteFile& file, const Kind& kind, const std::vector<DriveMarks>& drives)
{
    SqliteStatement row = file.prepare("INSERT INTO drive VALUES(?, ?, ?)");
    for (std::size_t k = 0; k < drives.size(); ++k) {
        row.bind(0, kind.name);
        row.bind(1, static_cast<std::int64_t>(k));
        row.bindBlob(2, bytesOf(drives[k].data(), std::ssize(drives[k])));
        row.run();
    }
}

void readInputs(SqliteFile& file, const Kind& kind, TrailNetworks& networks)
{
    std::vector<double> mean, sd;
    SqliteStatement row =
        file.prepare("SELECT position, mean, sd FROM input WHERE kind = ? ORDER BY position");
    row.bind(0, kind.name);
    while (row.step()) {
        require(row.integer(0) == std::ssize(mean) && std::ssize(mean) < kind.inputs,
                TR_NOOP("core", "its inputs are not those of this program"));
        mean.push_back(row.real(1));
        sd.push_back(row.real(2));
    }
    networks.inputMean = Eigen::Map<Eigen::VectorXd>(mean.data(), std::ssize(mean));
    networks.inputSd = Eigen::Map<Eigen::VectorXd>(sd.data(), std::ssize(sd));
}

void readScales(SqliteFile& file, const Kind& kind, TrailNetworks& networks)
{
    SqliteStatement row = file.prepare(
        "SELECT covered, bin, mean, sd FROM scale WHERE kind = ? ORDER BY covered, bin");
    row.bind(0, kind.name);
    for (auto* scales : {&networks.open, &networks.covered})
        for (int bin = 0; bin < kBins; ++bin) {
            require(row.step() && row.integer(0) == (scales == &networks.covered ? 1 : 0)
                        && row.integer(1) == bin,
                    TR_NOOP("core", "a bin's scale is missing"));
            (*scales)[static_cast<std::size_t>(bin)] = {row.real(2), row.real(3)};
        }
    require(!row.step(), TR_NOOP("core", "a bin has two scales"));
}

NetworkLayer layerOf(const SqliteStatement& row)
{
    const Eigen::Index outputs = row.integer(2), inputs = row.integer(3);
    require(outputs > 0 && outputs <= kMaxWidth && inputs > 0 && inputs <= kMaxWidth,
            TR_NOOP("core", "a layer of a network is too wide"));
    const std::vector<float> weight = numbersOf<float>(row.blob(4), outputs * inputs);
    const std::vector<float> bias = numbersOf<float>(row.blob(5), outputs);
    return {Eigen::Map<const Eigen::MatrixXf>(weight.data(), outputs, inputs),
            Eigen::Map<const Eigen::VectorXf>(bias.data(), outputs)};
}

void readLayers(SqliteFile& file, const Kind& kind, TrailNetworks& networks)
{
    SqliteStatement row = file.prepare(
        "SELECT network, layer, outputs, inputs, weight, bias FROM layer WHERE kind = ? ORDER BY "
        "network, layer");
    row.bind(0, kind.name);
    while (row.step()) {
        const std::int64_t network = row.integer(0), layer = row.integer(1);
        if (network == std::ssize(networks.networks) && layer == 0)
            networks.networks.emplace_back();
        require(!networks.networks.empty() && network == std::ssize(networks.networks) - 1
                    && network <= kMaxNetworks
                    && layer == std::ssize(networks.networks.back().layers) && layer < kMaxLayers,
                TR_NOOP("core", "a layer of a network is missing"));
        networks.networks.back().layers.push_back(layerOf(row));
    }
    if (networks.isEmpty()) return;
    networks.size = std::move(networks.networks.back());
    networks.networks.pop_back();
    require(!networks.isEmpty(), TR_NOOP("core", "a layer of a network is missing"));
}

int driveOf(std::int64_t number)
{
    require(number >= 0 && number <= kMaxDrive,
            TR_NOOP("core", "the number of a drive is out of range"));
    return static_cast<int>(number);
}

unsigned maskOf(std::int64_t number)
{
    require(number >= 0 && number < (std::int64_t{1} << kBins),
            TR_NOOP("core", "covered bins are out of range"));
    return static_cast<unsigned>(number);
}

void readErrors(SqliteFile& file, const Kind& kind, TrailNetworks& networks)
{
    std::vector<Eigen::VectorXf> predicted, residual;
    SqliteStatement row =
        file.prepare("SELECT scene, drive, covered_left, covered_right, predicted, "
                     "residual FROM error WHERE kind = ? ORDER BY scene");
    row.bind(0, kind.name);
    while (row.step()) {
        require(row.integer(0) == std::ssize(predicted) && row.integer(0) < kMaxTrailErrors,
                TR_NOOP("core", "a scene of the errors is missing, or there are too many"));
        networks.errors.drive.push_back(driveOf(row.integer(1)));
        networks.errors.covered.push_back({maskOf(row.integer(2)), maskOf(row.integer(3))});
        predicted.push_back(valuesOf(row.blob(4), kind.sides * kBins));
        residual.push_back(valuesOf(row.blob(5), kind.sides * kBins));
    }
    const Eigen::Index scenes = std::ssize(predicted);
    networks.errors.predicted.resize(kind.sides * kBins, scenes);
    networks.errors.residual.resize(kind.sides * kBins, scenes);
    for (Eigen::Index u = 0; u < scenes; ++u) {
        networks.errors.predicted.col(u) = predicted[static_cast<std::size_t>(u)];
        networks.errors.residual.col(u) = residual[static_cast<std::size_t>(u)];
    }
}

void readDriveMarks(SqliteFile& file, const Kind& kind, TrailNetworks& networks)
{
    SqliteStatement row =
        file.prepare("SELECT drive, scenes FROM drive WHERE kind = ? ORDER BY drive");
    row.bind(0, kind.name);
    while (row.step()) {
        const std::string marks = row.blob(1);
        require(row.integer(0) == std::ssize(networks.drives) && !marks.empty(),
                TR_NOOP("core", "a training drive is missing"));
        const auto count = static_cast<Eigen::Index>(marks.size() / sizeof(std::uint32_t));
        networks.drives.push_back(numbersOf<std::uint32_t>(marks, count));
    }
}

}  // namespace

std::span<const SqliteTable> tablesOf(std::int64_t version)
{
    const std::span<const SqliteTable> tables(allTables());
    return version == kVersionWithoutDrives ? tables.subspan(1) : tables;
}

void addContent(CanonicalBytes& bytes, const TrailNetworks& networks)
{
    for (Eigen::Index i = 0; i < networks.inputMean.size(); ++i) {
        bytes.add(networks.inputMean[i]);
        bytes.add(networks.inputSd[i]);
    }
    for (const bool covered : {false, true})
        for (const TrailScale& scale : scalesOf(networks, covered)) {
            bytes.add(scale.mean);
            bytes.add(scale.sd);
        }
    for (const Network* network : allOf(networks))
        for (const NetworkLayer& layer : network->layers) {
            bytes.add(bytesOf(layer.weight.data(), layer.weight.size()));
            bytes.add(bytesOf(layer.bias.data(), layer.bias.size()));
        }
    for (Eigen::Index u = 0; u < networks.errors.predicted.cols(); ++u) {
        for (const unsigned mask : networks.errors.covered[static_cast<std::size_t>(u)])
            bytes.add(std::uint64_t{mask});
        bytes.add(static_cast<std::uint64_t>(networks.errors.drive[static_cast<std::size_t>(u)]));
        bytes.add(stepsOf(networks.errors.predicted.col(u)));
        bytes.add(stepsOf(networks.errors.residual.col(u)));
    }
    for (const DriveMarks& marks : networks.drives)
        bytes.add(bytesOf(marks.data(), std::ssize(marks)));
}

void writeNetworks(SqliteFile& file, const Kind& kind, const TrailNetworks& networks)
{
    SqliteStatement input = file.prepare("INSERT INTO input VALUES(?, ?, ?, ?)");
    for (int i = 0; i < static_cast<int>(networks.inputMean.size()); ++i)
        insert(input, kind.name, i, networks.inputMean[i], networks.inputSd[i]);
    SqliteStatement scale = file.prepare("INSERT INTO scale VALUES(?, ?, ?, ?, ?)");
    for (const bool covered : {false, true})
        for (int bin = 0; bin < kBins; ++bin) {
            const TrailScale& own = scalesOf(networks, covered)[static_cast<std::size_t>(bin)];
            insert(scale, kind.name, bin, covered ? 1 : 0, own.mean, own.sd);
        }
    writeLayers(file, kind, networks);
    writeErrors(file, kind, networks.errors);
    writeDrives(file, kind, networks.drives);
}

TrailNetworks readNetworks(SqliteFile& file, const Kind& kind, std::int64_t version)
{
    TrailNetworks networks;
    readLayers(file, kind, networks);
    if (networks.isEmpty()) return networks;
    readInputs(file, kind, networks);
    readScales(file, kind, networks);
    readErrors(file, kind, networks);
    if (version != kVersionWithoutDrives) readDriveMarks(file, kind, networks);
    try {
        requireTrailNetworks(networks, kind.inputs, kind.sides);
    } catch (const std::invalid_argument& refused) {
        throw Refused{Message::verbatim(refused.what())};
    }
    return networks;
}

void requireKnownRows(SqliteFile& file, const TrailData& data, std::int64_t version)
{
    for (const SqliteTable& table : tablesOf(version)) {
        if (table.name == "meta") continue;
        for (const auto& [kind, networks] :
             {std::pair{&kPlaneKind, &data.plane}, std::pair{&kSideKind, &data.side}}) {
            if (!networks->isEmpty()) continue;
            SqliteStatement row =
                file.prepare(fmt::format("SELECT count(*) FROM {} WHERE kind = ?", table.name));
            row.bind(0, kind->name);
            require(row.step() && row.integer(0) == 0,
                    TR_NOOP("core", "it has rows of networks without layers"));
        }
        require(file.integer(fmt::format("SELECT count(*) FROM {} WHERE kind NOT IN ('plane', "
                                         "'side')",
                                         table.name))
                    == 0,
                TR_NOOP("core", "it has rows of an unknown kind of networks"));
    }
}

}  // namespace terratact::trail_file
