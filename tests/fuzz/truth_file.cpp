// Fuzzes truth files, by rows with any values, and decisions on their scenes. The first byte selects: d decisions.
#include "app/modelling/truth/truth_file.h"

#include <sqlite3.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/modelling/truth/truth_choices.h"
#include "app/modelling/truth/truth_decisions.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/row_bytes.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/support/made_truth.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

const ScratchFile& file()
{
    static const ScratchFile scratch("small.truth");
    return scratch;
}

/// Writes files beside the scratch file.
struct ScratchFolder {
    std::string write(const std::string& name, const std::string& text) const
    {
        files.push_back(std::make_unique<ScratchFile>(name));
        files.back()->write(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
        return files.back()->path();
    }
    mutable std::vector<std::unique_ptr<ScratchFile>> files{};
};

/// Heights of three scenes on a floor with a step.
const LaserTruth& realTruth()
{
    static const LaserTruth truth = [] {
        const ScratchFolder folder;
        return madeTruth(folder, 3);
    }();
    return truth;
}

const std::string& realTruthFile()
{
    static const std::string bytes = [] {
        promise(bool(writeTruthFile(file().path(), realTruth(),
                                    TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml")),
                "a truth file can be written");
        return file().read();
    }();
    return bytes;
}

void promiseBins(const SideTruth& side)
{
    for (const BinTruth& bin : side) {
        promise(!bin.height || std::abs(*bin.height) <= 10.0, "a height is in its range");
        promise(std::isfinite(bin.sd) && bin.sd >= 0.0, "an sd is in its range");
    }
}

/// Samples the heights of a scene again, with a moved cloud.
void fuzzAlong(TruthFile& opened, std::size_t row)
{
    if (!opened.truth().truths[row].hasPlace()) return;
    auto grid = opened.grid(row);
    if (!grid) return promiseRefusal(grid.error(), file().path());
    SceneTruth scene = opened.truth().truths[row];
    sampleAlong(scene, opened.truth(), *grid, 0, {.along = kMaxNudgeAlong});
    for (const SideTruth& side : scene.side)
        for (const BinTruth& bin : side)
            promise(!bin.height || std::isfinite(*bin.height), "a height is finite");
}

void fuzzRows(FuzzBytes bytes)
{
    const std::string& real = realTruthFile();
    file().write(reinterpret_cast<const std::uint8_t*>(real.data()), real.size());
    sqlite3* const db = openRows(file().path());
    while (bytes.left > 0) put(db, bytes.next() % 2 == 0 ? "scene" : "meta", bytes);
    sqlite3_close(db);
    auto opened = TruthFile::open(file().path());
    if (!opened) return promiseRefusal(opened.error(), file().path());
    const LaserTruth& truth = opened->truth();
    promise(truth.scenes() > 0 && truth.tracks.size() == truth.scenes(), "a file holds a scene");
    for (std::size_t row = 0; row < truth.scenes(); ++row) {
        promise(std::isfinite(truth.timeOf(row)), "a time is finite");
        for (const SideTruth& side : truth.truths[row].side) promiseBins(side);
        promiseBins(truth.truths[row].plane);
        const auto slice = opened->slice(row);
        if (!slice) {
            promiseRefusal(slice.error(), file().path());
            continue;
        }
        for (const SlicePoint& p : *slice)
            promise(std::abs(p.x) < 40.0 && std::abs(p.z) < 40.0, "a point is in its range");
        fuzzAlong(*opened, row);
    }
}

void fuzzDecisions(const std::uint8_t* data, std::size_t size)
{
    file().write(data, size);
    const auto decisions = readTruthDecisions(file().path());
    if (!decisions) return promiseRefusal(decisions.error(), file().path());
    for (const TruthDecision& d : *decisions)
        promise(d.row > 0 && std::abs(d.offset) <= kMaxNudge && std::abs(d.tilt) <= kMaxNudgeTilt
                    && std::abs(d.along) <= kMaxNudgeAlong,
                "a nudge is within its limits");
    const Status fit = checkTruthDecisions(realTruth(), *decisions, file().path());
    if (!fit) return promiseRefusal(fit.error(), file().path());
    LaserTruth truth = realTruth();
    promise(bool(applyTruthDecisions(truth, *decisions, file().path())),
            "decisions that fit can be applied");
    TruthChoices choices(realTruth());
    choices.load(*decisions);
    const std::string text = truthDecisionsCsv(choices.decisions());
    file().write(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    const auto again = readTruthDecisions(file().path());
    promise(again && truthDecisionsCsv(*again) == text, "decisions survive being written and read");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) return 0;
    if (*data == 'd')
        fuzzDecisions(data + 1, size - 1);
    else
        fuzzRows({data + 1, size - 1});
    return 0;
}
