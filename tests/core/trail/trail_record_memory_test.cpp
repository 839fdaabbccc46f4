// Measures the memory of a record of the way, and prints it for docs/memory.sh.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstddef>
#include <cstdio>
#include <memory>

#include "core/terrain/bins.h"
#include "core/trail/trail_record.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

/// Returns the bytes of the heap that are in use. A sanitizer has a heap of its own, which does not count.
std::size_t heapInUse()
{
    const struct mallinfo2 heap = mallinfo2();
    return heap.uordblks + heap.hblkhd;
}

/// Returns a line of a robot that presses all along its front flippers.
Measurement pressedLine()
{
    Measurement line;
    line.travelled = 0.0;
    line.turned = 0.0;
    SideForces forces;
    forces.left.fill(10.0);
    forces.right.fill(10.0);
    setSides(line, forces);
    return line;
}

/// Drives this way [m] with a line of telemetry every millimetre. At each place of the record there is a press. The arm
/// has a reading at each place in its reach.
void fill(TrailRecord& record, const RobotModel& robot, double way)
{
    constexpr int kLines = 20;                                          // from press to press
    constexpr double kWayOfLine = 1.001 * TrailRecord::kStep / kLines;  // [m]
    Measurement line = pressedLine();
    for (int k = 0; *line.travelled < way; ++k) {
        line.time += 0.01;
        *line.travelled += kWayOfLine;
        record.add(line);
        if (k % kLines != 0) continue;
        record.addScene(line);
        for (const ProbeSide side : {ProbeSide::Middle, ProbeSide::Left, ProbeSide::Right})
            for (int bin = 0; bin < kBins; ++bin)
                if (robot.armReaches(bin, side)) record.addArm(line, {.bin = bin, .side = side});
    }
}

TEST(TrailRecordMemory, aFullRecordStaysBelowOneMegabyte)
{
    const RobotModel robot = absolem();
    const std::size_t before = heapInUse();
    const auto record = std::make_unique<TrailRecord>(robot);
    fill(*record, robot, 2.0 * TrailRecord::kLength);
    const std::size_t bytes = heapInUse() - before;
    EXPECT_NEAR(record->length(), TrailRecord::kLength, TrailRecord::kStep);
    EXPECT_FALSE(record->armHere().empty());
    if (bytes == 0) GTEST_SKIP() << "the heap of a sanitizer does not count";
    RecordProperty("bytes", static_cast<int>(bytes));
    std::printf("record of %.1f m: %.3f MB\n", TrailRecord::kLength,
                1e-6 * static_cast<double>(bytes));
    EXPECT_LE(bytes, 1'000'000U);
    EXPECT_GT(bytes, 100'000U) << "the measurement worked";
}

}  // namespace
}  // namespace terratact
