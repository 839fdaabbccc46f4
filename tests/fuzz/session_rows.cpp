// Fuzzes rows of a session with any values and valid hashes, like those of a forger. Returned values are finite and in
// range.
#include <sqlite3.h>

#include <cmath>
#include <cstdint>

#include "core/log/rows/session_schema.h"
#include "core/log/session_reader.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/row_bytes.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/support/sessions/session_rehash.h"
#include "tests/support/sessions/sessions.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

const ScratchFile& file()
{
    static const ScratchFile scratch("rows.tts");
    return scratch;
}

const std::string& realSession()
{
    static const std::string bytes = [] {
        std::filesystem::remove(file().path());
        auto writer = someSession(file().path(), 8);
        promise(writer && writer->seal(), "a session can be written");
        return file().read();
    }();
    return bytes;
}

void promiseFinite(double value)
{
    promise(std::isfinite(value), "a number is finite");
}

void promiseEstimate(const EstimateRow& row)
{
    for (const TerrainEstimate& side : row.estimate.side) {
        for (std::size_t i = 0; i < kBins; ++i)
            for (const double value :
                 {side.mean[i], side.sd[i], side.q10[i], side.q90[i], side.height[i]})
                promiseFinite(value);
        promiseFinite(side.novelty);
        promiseFinite(side.feltTo);
        promise(side.settings.draws > 0, "settings are in range");
    }
    promise(!row.estimate.onePlane || row.estimate.side[0] == row.estimate.side[1],
            "both sides of one plane are equal");
    promise(row.estimate.side[0].settings == row.estimate.side[1].settings,
            "both sides have the same settings");
    for (const ArmReading& reading : row.readings) {
        promise(reading.bin >= 0 && reading.bin < kBins, "a reading's bin exists");
        promiseFinite(reading.height);
    }
}

void promiseDraws(const SideDraws& draws, bool onePlane)
{
    for (const auto& side : draws)
        for (const Heights& draw : side)
            for (const double height : draw) promiseFinite(height);
    promise(draws[0].size() == draws[1].size(), "a draw is of both sides");
    promise(!onePlane || draws[0] == draws[1], "draws of one plane are those of both sides");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string& real = realSession();
    file().write(reinterpret_cast<const std::uint8_t*>(real.data()), real.size());
    FuzzBytes bytes{data, size};
    sqlite3* const db = openRows(file().path());
    while (bytes.left > 0) {
        const std::uint8_t table = bytes.next() % (kSessionRowTables.size() + 3);
        put(db,
            table < kSessionRowTables.size()        ? std::string(kSessionRowTables.at(table))
            : table == kSessionRowTables.size()     ? "can_frame"
            : table == kSessionRowTables.size() + 1 ? "batch"
                                                    : "estimate_draws",
            bytes);
    }
    sqlite3_close(db);
    try {
        rehash(file().path());
    } catch (const SqliteError&) {
        // the reader opens the file in any case
    }
    auto session = SessionReader::open(file().path());
    if (!session) return promiseRefusal(session.error(), file().path()), 0;
    for (std::size_t i = 0; i < session->batches().size(); ++i)
        for (const FrameRow& frame : session->frames(i))
            promise(frame.frame.fd || frame.frame.length <= 8, "a frame has at most eight bytes");
    for (const EstimateRow& row : session->estimates()) {
        promiseEstimate(row);
        if (const auto draws = session->draws(row.id)) promiseDraws(*draws, row.estimate.onePlane);
    }
    for (const SceneRow& row : session->scenes()) {
        promiseFinite(row.measurement.pitch);
        for (const double force : row.measurement.force) promiseFinite(force);
        for (const SideForces& sides : {row.measurement.sides, row.measurement.rearSides})
            for (const auto& side : {sides.left, sides.right})
                for (const auto& force : side) promiseFinite(force.value_or(0.0));
        promiseFinite(row.measurement.differential.value_or(0.0));
        if (row.sideTruth)
            for (const Heights& side : *row.sideTruth)
                for (const double height : side) promiseFinite(height);
    }
    for (const ProposalRow& row : session->proposals())
        promise(row.bin >= 0 && row.bin < kBins, "a proposal's bin exists");
    return 0;
}
