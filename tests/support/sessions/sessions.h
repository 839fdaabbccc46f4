#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/log/rows/session_rows.h"
#include "core/log/session_writer.h"
#include "tests/support/estimates.h"

/// Sessions for tests that need one with a row of every kind.
namespace terratact {

inline SessionStart someStart()
{
    return {.wallTime = 1'793'000'000'000'000'000,
            .program = "terratact-console test",
            .source = "SIMULATED ROBOT",
            .bus = "can0",
            .transmits = true,
            .robot = "name = \"a robot\"\n",
            .robotHash = std::string(64, 'a')};
}

/// Returns frame number n of a session, at n milliseconds.
inline FrameRow someFrame(std::int64_t n)
{
    FrameRow row{.time = n * 1'000'000};
    row.frame.id = static_cast<std::uint32_t>(0x100 + n % 16);
    row.frame.length = 8;
    for (std::size_t i = 0; i < 8; ++i)
        row.frame.data[i] = static_cast<std::uint8_t>(n >> (8 * i) & 0xFF);
    row.sent = n % 7 == 0;
    return row;
}

inline EstimateRow someEstimate(std::int64_t id, SessionTime time)
{
    EstimateRow row{.id = id, .time = time, .scene = id, .model = 1, .seconds = 0.25};
    TerrainEstimate plane = stepEstimate();
    plane.settings.seed = 18'446'744'073'709'551'615U;
    plane.settings.draws = 4;
    plane.warnings = {Message::verbatim("chains have not converged"),
                      Message::verbatim("left and right differ")};
    plane.draws.assign(4, plane.height);
    plane.draws[1][3] = -0.125;
    row.estimate = equalSides(std::move(plane));
    if (id > 1) {
        row.role = EstimateRole::Again;
        row.readings = {{.bin = 9, .height = -0.04, .sd = 0.03}};
    }
    return row;
}

/// Returns an estimate of two sides that differ in everything but their settings: a step on the left
/// side alone.
inline EstimateRow someSides(std::int64_t id, SessionTime time)
{
    EstimateRow row = someEstimate(id, time);
    row.estimate.onePlane = false;
    TerrainEstimate& right = row.estimate.side[1];
    for (std::size_t i = 0; i < kBins; ++i) {
        right.height[i] = right.mean[i] = -0.25 + 0.001 * static_cast<double>(i);
        right.sd[i] = 0.02;
        right.q10[i] = right.height[i] - 0.03;
        right.q90[i] = right.height[i] + 0.03;
        right.ceiling[i] = i < 4 ? 0.1 : std::numeric_limits<double>::infinity();
        right.origin[i] = i == 9 ? Origin::Arm : Origin::Sampled;
        right.touch[i] = i == 8 ? Touch::Felt : Touch::NotFelt;
        right.rhat[i] = 1.001;
        right.ess[i] = 900.0;
    }
    right.feltTo = 0.31;
    right.novelty = 0.75;
    right.contradicts = true;
    right.converged = false;
    right.ending = Ending::Sweeps;
    right.warnings = {Message::verbatim("the right side alone")};
    right.draws.assign(4, right.height);
    right.draws[2][10] = 0.0625;
    return row;
}

inline TrailHistory someMemory()
{
    TrailHistory memory = emptyHistory(0.05, -0.01);
    memory.way = 0.75;
    memory.presses = 3;
    memory.roll[4] = 0.02;
    memory.ground[0].lowest[2] = -0.125;
    memory.ground[1].load[5] = 3.5;
    memory.ground[2].pressed[8] = -0.0625;
    return memory;
}

inline SceneRow someScene(std::int64_t id, SessionTime time)
{
    SceneRow row{.id = id, .time = time};
    row.measurement.pitch = 0.05;
    SideForces sides;
    sides.left = sides.right = {0.0, 1.0, 2.5, 0.0, 0.0, 7.0};
    setSides(row.measurement, sides);
    row.measurement.activity = RobotActivity::Pressed;
    if (id > 1) row.measurement.arm = ArmReading{.bin = 9, .height = -0.04, .sd = 0.03};
    row.measurement.travelled = 1.25;
    row.truth = stepEstimate().height;
    if (id == 1) row.memory = someMemory();
    return row;
}

inline ProposalRow someProposal(SessionTime time)
{
    return {.id = 1,
            .time = time,
            .estimate = 1,
            .bin = 9,
            .height = -0.05,
            .q10 = -0.17,
            .q90 = 0.07,
            .sd = 0.09,
            .limit = 0.06,
            .armSd = 0.03,
            .seconds = 45.0,
            .stepLimit = 0.1,
            .bitsBefore = 0.8,
            .grounds = std::string(64, 'b'),
            .offers = {{9, 0.5, 0.3}, {10, 0.4, 0.35}}};
}

inline EventRow someDecision(SessionTime time)
{
    return {.id = 2,
            .time = time,
            .kind = EventKind::Decision,
            .subject = "approve",
            .text = "probe at 0.6 m",
            .number = 9.0,
            .estimate = 1,
            .proposal = 1,
            .shown = "CANNOT TELL 41 %",
            .screen = {SourceText{"core", "CANNOT TELL %1 %"}, 41}};
}

/// Writes a session of `frames` frames in batches of 100, with two scenes and a probe. Not sealed.
inline Result<SessionWriter> someSession(const std::string& path, std::int64_t frames,
                                         const SessionStart& start = someStart())
{
    auto writer = SessionWriter::create(path, start);
    if (!writer) return writer;
    (void)writer->add(EventRow{.id = 1, .kind = EventKind::Session, .subject = "begun"});
    (void)writer->add(ModelRow{.id = 1,
                               .name = "default.ttm",
                               .hash = std::string(64, 'c'),
                               .trailName = "default.ttn",
                               .trailHash = std::string(64, 'd')});
    for (std::int64_t n = 0; n < frames; ++n) {
        (void)writer->add(someFrame(n));
        if (n == frames / 4) {
            (void)writer->add(someScene(1, n * 1'000'000));
            (void)writer->add(someEstimate(1, n * 1'000'000 + 1));
            (void)writer->add(someProposal(n * 1'000'000 + 2));
        }
        if (n == frames / 2) {
            (void)writer->add(someDecision(n * 1'000'000));
            (void)writer->add(someScene(2, n * 1'000'000 + 1));
            (void)writer->add(someSides(2, n * 1'000'000 + 2));
        }
        if (n % 100 == 99)
            if (const Status done = writer->commit(); !done) return done.error();
    }
    if (const Status done = writer->commit(); !done) return done.error();
    return writer;
}

}  // namespace terratact
