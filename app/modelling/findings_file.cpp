#include "app/modelling/findings_file.h"

#include <algorithm>
#include <fmt/format.h>

#include <array>
#include <fstream>
#include <limits>

#include "app/modelling/findings_tables.h"
#include "core/base/text.h"
#include "core/store/canonical_bytes.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sha256.h"
#include "core/store/sqlite_tables.h"

namespace terratact {
namespace {

constexpr std::uintmax_t kMaxBytes = std::uintmax_t{1} << 30U;
constexpr std::int64_t kMaxCount = 10'000'000;
constexpr double kMaxNumber = 1e9;
constexpr std::size_t kMaxText = 10'000;  // [B] bound of the texts about the evaluation
constexpr std::size_t kMaxLabel = 200;    // [B] each row of a run repeats the label

/// Reason to refuse a file, without the file's name. Thrown and caught in this file only.
struct Refused {
    std::string cause;
};

void require(bool holds, const std::string& cause)
{
    if (!holds) throw Refused{cause};
}

void addTo(CanonicalBytes& bytes, std::int64_t value)
{
    bytes.add(static_cast<std::uint64_t>(value));
}
void addTo(CanonicalBytes& bytes, double value)
{
    bytes.add(value);
}
void addTo(CanonicalBytes& bytes, const std::string& value)
{
    bytes.add(std::string_view(value));
}

template <class Number>
std::int64_t integer(Number number)
{
    return static_cast<std::int64_t>(number);
}

/// Returns the number of the run with the entry's label.
template <class Errors>
std::int64_t runOf(const Findings& findings, const Errors& entry)
{
    const auto found = std::find_if(findings.runs.begin(), findings.runs.end(),
                                    [&](const MethodRun& r) { return r.label == entry.label; });
    return found - findings.runs.begin();
}

std::int64_t maskOf(const std::vector<int>& bins)
{
    std::int64_t mask = 0;
    for (const int bin : bins) mask |= std::int64_t{1} << bin;
    return mask;
}

std::vector<int> binsOfMask(std::int64_t mask)
{
    std::vector<int> bins;
    for (int bin = 0; bin < kBins; ++bin)
        if ((mask >> bin & 1) != 0) bins.push_back(bin);
    return bins;
}

// ---------------------------------------------------------------- writing

/// Fills tables row by row, numbered from 0, and hashes every value.
class Writer {
public:
    explicit Writer(SqliteFile& file) : file_(file) {}

    /// Writes the rows of one table; row(entry, put) calls put(values…) for one entry.
    template <class Entries, class Row>
    void fill(const std::string& table, int columns, const Entries& entries, Row row)
    {
        std::string sql = "INSERT INTO " + table + " VALUES(?";
        for (int k = 0; k < columns; ++k) sql += ", ?";
        SqliteStatement insert = file_.prepare(sql + ")");
        bytes_.add(std::string_view(table));
        std::int64_t position = 0;
        for (const auto& entry : entries)
            row(entry, [&](const auto&... values) {
                int parameter = 0;
                insert.bind(parameter++, position++);
                (insert.bind(parameter++, values), ...);
                insert.run();
                (addTo(bytes_, values), ...);
            });
    }
    std::string hash() const { return sha256Hex(bytes_.bytes()); }

private:
    SqliteFile& file_;
    CanonicalBytes bytes_;
};

void writeShared(Writer& writer, const Findings& f)
{
    writer.fill("part", 7, std::array{&f.options}, [&](const ReportOptions* o, auto put) {
        put(integer(f.shard.number), integer(f.shard.count), integer(f.total),
            std::to_string(o->seed), o->stepLimit, o->sdLimit, integer(o->classes));
    });
    writer.fill("meta", 2, f.origin,
                [](const auto& mark, auto put) { put(mark.first, mark.second); });
    writer.fill("method", 1, f.options.methods,
                [](Method method, auto put) { put(std::string(name(method))); });
    writer.fill("scene", 4, f.scenes, [](const EvaluatedScene& s, auto put) {
        put(s.run, s.time, maskOf(s.underFlipper), s.kind);
    });
    writer.fill("method_run", 7, f.runs, [](const MethodRun& r, auto put) {
        put(r.label, integer(r.scenes), integer(r.converged), integer(r.endedBySweeps),
            integer(r.endedByTime), integer(r.failed), r.seconds);
    });
}

void writeErrors(Writer& writer, const Findings& f)
{
    writer.fill("bin_error", 13, f.errors, [&](const BinError& e, auto put) {
        const ForecastScores& s = e.scores;
        put(integer(e.scene), runOf(f, e), integer(e.bin), e.error, s.crps, s.pit, integer(s.in50),
            integer(s.in80), integer(s.in95), s.width, integer(e.origin), e.novelty, e.truthSd);
    });
    writer.fill("step_forecast", 5, f.steps, [&](const StepForecast& s, auto put) {
        put(integer(s.scene), runOf(f, s), integer(s.place), s.probability, integer(s.observed));
    });
}

void writeProbes(Writer& writer, const Findings& f)
{
    writer.fill("probe_run", 2, f.probes,
                [](const ProbeRun& r, auto put) { put(r.label, r.rule); });
    std::vector<std::pair<std::int64_t, ProbeTrial>> trials;
    for (const ProbeRun& run : f.probes)
        for (const ProbeTrial& trial : run.trials)
            trials.emplace_back(&run - f.probes.data(), trial);
    writer.fill("probe_trial", 7, trials, [](const auto& entry, auto put) {
        const auto& [run, t] = entry;
        put(run, t.before.ahead, t.before.all, t.after.ahead, t.after.all, integer(t.probes),
            integer(t.settled));
    });
}

void fill(const std::string& path, const Findings& findings)
{
    SqliteFile file = SqliteFile::fill(path);
    file.run("PRAGMA application_id = " + std::to_string(kFindingsApplicationId));
    file.run("PRAGMA user_version = " + std::to_string(kFindingsVersion));
    for (const SqliteTable& table : findingsTables()) file.run(table.sql);
    file.run("BEGIN");
    Writer writer(file);
    writeShared(writer, findings);
    writeErrors(writer, findings);
    writeProbes(writer, findings);
    const std::string hash = writer.hash();
    writer.fill("content", 1, std::array{hash}, [](const std::string& h, auto put) { put(h); });
    file.run("COMMIT");
    file.run("VACUUM");
    file.close();
}

// ---------------------------------------------------------------- reading

/// Reads tables row by row in the order of Writer, and hashes every value.
class Reader {
public:
    explicit Reader(SqliteFile& file) : file_(file) {}

    /// Calls row() for every row of one table; row reads its values with integer, real, text.
    template <class Row>
    void read(const std::string& table, Row row)
    {
        SqliteStatement select = file_.prepare("SELECT * FROM " + table + " ORDER BY position");
        statement_ = &select;
        table_ = table;
        bytes_.add(std::string_view(table));
        for (std::int64_t position = 0; select.step(); ++position) {
            require(select.integer(0) == position,
                    "the rows of its table " + table + " are not numbered from 0");
            column_ = 1;
            row();
        }
    }
    std::int64_t integer(std::int64_t least, std::int64_t most)
    {
        const std::int64_t value = statement_->integer(column_++);
        require(value >= least && value <= most, "a number is out of range in its table " + table_);
        addTo(bytes_, value);
        return value;
    }
    std::size_t count(std::size_t most)
    {
        return static_cast<std::size_t>(integer(0, static_cast<std::int64_t>(most)));
    }
    bool flag() { return integer(0, 1) == 1; }
    double real(double least = -kMaxNumber, double most = kMaxNumber)
    {
        const double value = statement_->real(column_++);
        require(value >= least && value <= most, "a number is out of range in its table " + table_);
        addTo(bytes_, value);
        return value;
    }
    std::string text(std::size_t longest = kMaxText)
    {
        std::string value = statement_->text(column_++);
        require(value.size() <= longest && printable(value) == value,
                "a text is too long or no line in its table " + table_);
        addTo(bytes_, value);
        return value;
    }
    std::string hash() const { return sha256Hex(bytes_.bytes()); }

private:
    SqliteFile& file_;
    SqliteStatement* statement_ = nullptr;  ///< statement of the table being read
    std::string table_;
    int column_ = 0;
    CanonicalBytes bytes_;
};

void checkIdentity(SqliteFile& file)
{
    require(file.integer("PRAGMA application_id") == kFindingsApplicationId,
            "is an SQLite file of another application, not a part of an evaluation");
    const std::int64_t version = file.integer("PRAGMA user_version");
    require(version == kFindingsVersion, "is a part of format version " + std::to_string(version)
                                             + ", and this program reads version "
                                             + std::to_string(kFindingsVersion));
}

void checkSchema(SqliteFile& file)
{
    require(hasOnlyTables(file, findingsTables()),
            "its tables are not those of a part of an evaluation");
}

std::uint64_t seedFrom(const std::string& text)
{
    const auto seed = writtenIntegerFrom<std::uint64_t>(text);
    require(seed.has_value(), "its seed is not a number: " + shown(text));
    return *seed;
}

Method methodOf(const std::string& text)
{
    const auto method = methodFromName(text);
    require(method.has_value(), "has an unknown method: " + shown(text));
    return *method;
}

void readPart(Reader& reader, Findings& f)
{
    int rows = 0;
    reader.read("part", [&] {
        f.shard.number = static_cast<int>(reader.integer(1, kMaxCount));
        f.shard.count = static_cast<int>(reader.integer(f.shard.number, kMaxCount));
        f.total = reader.count(kMaxCount);
        f.options.seed = seedFrom(reader.text());
        f.options.stepLimit = reader.real(0.0);
        f.options.sdLimit = reader.real(0.0);
        f.options.classes = reader.flag();
        ++rows;
    });
    require(rows == 1, "does not say which part it is");
}

void readShared(Reader& reader, Findings& f)
{
    reader.read("meta", [&] {
        std::string key = reader.text();
        f.origin[std::move(key)] = reader.text();
    });
    reader.read("method", [&] { f.options.methods.push_back(methodOf(reader.text())); });
    reader.read("scene", [&] {
        EvaluatedScene& scene = f.scenes.emplace_back();
        scene.run = reader.text();
        scene.time =
            reader.real(-std::numeric_limits<double>::max(), std::numeric_limits<double>::max());
        scene.underFlipper = binsOfMask(reader.integer(0, (std::int64_t{1} << kBins) - 1));
        scene.kind = reader.text();
    });
    require(f.scenes.size() == f.shard.end(f.total) - f.shard.begin(f.total),
            "does not hold the scenes of its part");
    reader.read("method_run", [&] {
        MethodRun& run = f.runs.emplace_back();
        run.label = reader.text(kMaxLabel);
        run.scenes = reader.count(f.scenes.size());
        run.converged = reader.count(f.scenes.size());
        run.endedBySweeps = reader.count(f.scenes.size());
        run.endedByTime = reader.count(f.scenes.size());
        run.failed = reader.count(f.scenes.size());
        run.seconds = reader.real(0.0);
    });
    require(f.runs.size() >= f.options.methods.size(), "lacks a method");
}

/// Reads a scene number and checks that the scene belongs to this part.
std::size_t readScene(Reader& reader, const Findings& f)
{
    return static_cast<std::size_t>(
        reader.integer(integer(f.shard.begin(f.total)), integer(f.shard.end(f.total)) - 1));
}

const std::string& readLabel(Reader& reader, const Findings& f)
{
    return f.runs[static_cast<std::size_t>(reader.integer(0, std::ssize(f.runs) - 1))].label;
}

void readErrors(Reader& reader, Findings& f)
{
    reader.read("bin_error", [&] {
        BinError& e = f.errors.emplace_back();
        e.scene = readScene(reader, f);
        e.label = readLabel(reader, f);
        e.bin = static_cast<int>(reader.integer(0, kBins - 1));
        e.error = reader.real();
        e.scores.crps = reader.real();
        e.scores.pit = reader.real(0.0, 1.0);
        e.scores.in50 = reader.flag();
        e.scores.in80 = reader.flag();
        e.scores.in95 = reader.flag();
        e.scores.width = reader.real();
        e.origin = static_cast<Origin>(reader.integer(0, 2));
        e.novelty = reader.real(0.0, std::numeric_limits<double>::max());
        e.truthSd = reader.real(0.0, std::numeric_limits<double>::max());
    });
    reader.read("step_forecast", [&] {
        StepForecast& s = f.steps.emplace_back();
        s.scene = readScene(reader, f);
        s.label = readLabel(reader, f);
        s.place = static_cast<StepPlace>(reader.integer(0, 1));
        s.probability = reader.real(0.0, 1.0);
        s.observed = reader.flag();
    });
}

void readProbes(Reader& reader, Findings& f)
{
    reader.read("probe_run", [&] {
        ProbeRun& run = f.probes.emplace_back();
        run.label = reader.text(kMaxLabel);
        run.rule = reader.text();
    });
    reader.read("probe_trial", [&] {
        auto& trials =
            f.probes[static_cast<std::size_t>(reader.integer(0, std::ssize(f.probes) - 1))].trials;
        ProbeTrial& t = trials.emplace_back();
        t.before.ahead = reader.real(0.0);
        t.before.all = reader.real(0.0);
        t.after.ahead = reader.real(0.0);
        t.after.all = reader.real(0.0);
        t.probes = static_cast<int>(reader.integer(0, kMaxCount));
        t.settled = reader.flag();
    });
}

Findings readStored(SqliteFile& file)
{
    checkIdentity(file);
    checkSchema(file);
    Findings findings;
    Reader reader(file);
    readPart(reader, findings);
    readShared(reader, findings);
    readErrors(reader, findings);
    readProbes(reader, findings);
    const std::string hash = reader.hash();
    std::string stored;
    reader.read("content", [&] { stored += reader.text(); });
    require(hash == stored,
            "its content was altered: it does not have the hash that was stored with it");
    return findings;
}

}  // namespace

Status writeFindings(const std::string& path, const Findings& findings)
{
    Result<NewFile> file = NewFile::begin(path);
    if (!file) return file.error();
    try {
        fill(file->temporaryPath(), findings);
    } catch (const SqliteError& error) {
        return fileError(path, "cannot be written: " + std::string(error.what()));
    }
    return file->commit();
}

std::string shardFile(const Shard& shard)
{
    return fmt::format("part_{}_of_{}.tte", shard.number, shard.count);
}

bool isFindingsFile(const std::string& path)
{
    std::array<char, 72> header{};  // SQLite stores the application_id in bytes 68 to 71.
    std::ifstream in(path, std::ios::binary);
    in.read(header.data(), header.size());
    return in && std::string_view(&header[68], 4) == "TTE1";
}

Result<Findings> readFindings(const std::string& path)
{
    try {
        SqliteFile file = SqliteFile::openUntrusted(path, kMaxBytes);
        return readStored(file);
    } catch (const SqliteError& error) {
        return fileError(path, error.what());
    } catch (const Refused& refused) {
        return fileError(path, refused.cause);
    }
}

}  // namespace terratact
