#include "app/modelling/truth/truth_decisions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>

#include "app/modelling/truth/truth_sampling.h"
#include "core/base/text.h"
#include "core/store/csv_reader.h"
#include "core/store/csv_text.h"
#include "core/store/file_read.h"
#include "core/terrain/bins.h"

namespace terratact {
namespace {

constexpr const char* kDecisionHeader = "row,run,decision,offset_m,tilt_rad,along_m";
constexpr const char* kOlderHeader = "row,run,decision,offset_m,tilt_rad";

constexpr double kCellSlack = 1e-6;  // [m] of a number of cells

Result<double> nudgeOf(CsvReader& csv, std::size_t field, const char* what, double most)
{
    if (csv.isMissing(field)) return 0.0;
    auto value = csv.number(field, what);
    if (value && std::abs(*value) > most)
        return csv.error(
            Message(TR_NOOP("core", "%1 is %2, expected %3 to %4"), what, *value, -most, most));
    return value;
}

Result<TruthDecision> decisionOf(CsvReader& csv)
{
    TruthDecision decision{.line = csv.line()};
    const auto row = csv.number(0, "row");
    if (!row) return row.error();
    if (*row < 1.0 || *row > 1e9 || *row != std::floor(*row))
        return csv.error(
            Message(TR_NOOP("core", "row is %1, expected the number of a scene, from 1"), *row));
    decision.row = static_cast<std::size_t>(*row);
    decision.run = csvText(csv.fields()[1]);
    const std::string_view word = csv.fields()[2];
    if (word != "accept" && word != "exclude")
        return csv.error(
            Message(TR_NOOP("core", "decision is %1, expected accept or exclude"), shown(word)));
    if (word == "exclude") decision.kind = TruthDecision::Kind::Exclude;
    const auto offset = nudgeOf(csv, 3, "offset_m", kMaxNudge);
    if (!offset) return offset.error();
    const auto tilt = nudgeOf(csv, 4, "tilt_rad", kMaxNudgeTilt);
    if (!tilt) return tilt.error();
    decision.offset = *offset;
    decision.tilt = *tilt;
    if (csv.fields().size() < 6) return decision;
    const auto along = nudgeOf(csv, 5, "along_m", kMaxNudgeAlong);
    if (!along) return along.error();
    decision.along = *along;
    if (std::abs(decision.cellsAlong() * kTruthCell - *along) > kCellSlack)
        return csv.error(Message(
            TR_NOOP("core", "along_m is %1, expected a multiple of %2: the cells of the cloud"),
            *along, kTruthCell));
    return decision;
}

/// Changes every known height by `change(bin)`, or forgets it where that is empty.
template <class Change>
void changeHeights(LaserTruth& truth, std::size_t row, const Change& change)
{
    const auto changeOne = [&](std::optional<double>& height, std::size_t bin) {
        if (!height) return;
        const std::optional<double> by = change(bin);
        height = by ? std::optional(*height + *by) : std::nullopt;
    };
    SceneTruth& scene = truth.truths[row];
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        for (SideTruth* side : {&scene.side[0], &scene.side[1], &scene.plane})
            changeOne((*side)[bin].height, bin);
        for (std::size_t side = 0; side < 2; ++side) {
            std::optional<double>& height = truth.tracks[row].truth.at(side).at(bin);
            changeOne(height, bin);
            if (!height) truth.tracks[row].truthSd.at(side).at(bin).reset();
        }
        if (!truth.isPlane) continue;
        changeOne(truth.plane[row].truth.at(bin), bin);
        if (!truth.plane[row].truth.at(bin)) truth.plane[row].truthSd.at(bin).reset();
    }
}

/// Moves the cloud of a scene along the way and samples its heights again.
Status moveAlong(LaserTruth& truth, const TruthDecision& decision, const CellsOfRow& cells)
{
    const std::size_t row = decision.row - 1;
    SceneTruth& scene = truth.truths[row];
    if (!scene.hasPlace()) return Done{};
    if (truth.grid) {
        sampleAlong(scene, truth, *truth.grid, scene.place, decision);
    } else {
        auto own = cells(row);
        if (!own) return own.error();
        sampleAlong(scene, truth, *own, 0, decision);
    }
    putTruth(truth, row);
    return Done{};
}

Status applyDecision(LaserTruth& truth, const TruthDecision& decision, const CellsOfRow& cells)
{
    const std::size_t row = decision.row - 1;
    SceneTruth& scene = truth.truths[row];
    if (decision.kind == TruthDecision::Kind::Exclude) {
        changeHeights(truth, row, [](std::size_t) { return std::optional<double>(); });
        if (scene.gap == TruthGap::None) scene.gap = TruthGap::Excluded;
        return Done{};
    }
    if (decision.cellsAlong() != 0)
        if (Status moved = moveAlong(truth, decision, cells); !moved) return moved;
    changeHeights(truth, row, [&](std::size_t bin) {
        return std::optional(decision.nudgeAt(binCentre(static_cast<int>(bin))));
    });
    scene.correction.offset += decision.offset;
    scene.correction.tiltX += std::tan(decision.tilt);
    return Done{};
}

}  // namespace

Result<std::vector<TruthDecision>> readTruthDecisions(const std::string& path)
{
    auto csv = CsvReader::open(path);
    if (!csv) return csv.error();
    if (const auto header = csv->next(); !header) return header.error();
    const std::string header = fmt::format("{}", fmt::join(csv->fields(), ","));
    if (header != kDecisionHeader && header != kOlderHeader)
        return csv->error(Message(TR_NOOP("core", "is not the header %1"), kDecisionHeader));
    std::vector<std::string> columnUnits{"", "", "", "m", "rad"};
    if (header == kDecisionHeader) columnUnits.emplace_back("m");
    csv->useAsHeader(columnUnits);
    std::vector<TruthDecision> decisions;
    std::set<std::size_t> rows;
    for (;;) {
        const auto more = csv->next();
        if (!more) return more.error();
        if (!*more) return decisions;
        auto decision = decisionOf(*csv);
        if (!decision) return decision.error();
        if (!rows.insert(decision->row).second)
            return csv->error(Message(
                TR_NOOP("core", "row %1 already has a decision above, expected one for each row"),
                decision->row));
        decisions.push_back(std::move(*decision));
    }
}

double TruthDecision::nudgeAt(double x) const
{
    return offset + std::tan(tilt) * x;
}

int TruthDecision::cellsAlong() const
{
    return static_cast<int>(std::lround(along / kTruthCell));
}

void sampleAlong(SceneTruth& scene, const LaserTruth& truth, SceneGrid& grid, std::size_t place,
                 const TruthDecision& decision)
{
    if (!scene.hasPlace() || scene.gap == TruthGap::OffCloud) return;
    grid.moveAlong(place, decision.cellsAlong());
    sampleTruth(scene, truth.robot, grid, place, truth.rule);
}

std::string truthDecisionsCsv(const std::vector<TruthDecision>& decisions)
{
    std::string text = std::string(kDecisionHeader) + '\n';
    for (const TruthDecision& d : decisions)
        text += csvLine({static_cast<double>(d.row), d.run,
                         d.kind == TruthDecision::Kind::Accept ? "accept" : "exclude", d.offset,
                         d.tilt, d.along});
    return text;
}

Status checkTruthDecisions(const LaserTruth& truth, const std::vector<TruthDecision>& decisions,
                           const std::string& path)
{
    for (const TruthDecision& d : decisions) {
        if (d.row < 1 || d.row > truth.scenes())
            return fileError(path,
                             Message(TR_NOOP("core", "line %1: row %2 does not exist, the scenes "
                                                     "have %3 rows; were they made again?"),
                                     d.line, d.row, truth.scenes()));
        const std::string& run = truth.runOf(d.row - 1);
        if (!d.run.empty() && d.run != run)
            return fileError(path,
                             Message(TR_NOOP("core", "line %1: row %2 belongs to the run %3, not "
                                                     "%4: take the decisions on these scenes"),
                                     d.line, d.row, shown(run), shown(d.run)));
    }
    return Done{};
}

Status applyTruthDecisions(LaserTruth& truth, const std::vector<TruthDecision>& decisions,
                           const std::string& path, const CellsOfRow& cells)
{
    if (Status fits = checkTruthDecisions(truth, decisions, path); !fits) return fits;
    for (const TruthDecision& decision : decisions)
        if (Status done = applyDecision(truth, decision, cells); !done) return done;
    return Done{};
}

}  // namespace terratact
