// Session files: the memory of the way is read back bit for bit, and numbers that cannot be are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "core/log/rows/session_memory.h"
#include "core/log/session_reader.h"
#include "core/log/session_writer.h"
#include "tests/core/log/session_fixture.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

TEST_F(Session, keepsTheMemoryOfAScene)
{
    seal(path, 200);
    const auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    ASSERT_EQ(reader->scenes().size(), 2U);
    EXPECT_EQ(reader->scenes()[0].memory, someMemory());
    EXPECT_FALSE(reader->scenes()[1].memory);
    EXPECT_EQ(reader->models().at(0).trailName, "default.ttn");
    EXPECT_EQ(reader->models()[0].trailHash, std::string(64, 'd'));
}

TEST(SessionMemory, EveryNumberSurvivesItsBytes)
{
    TrailHistory memory = someMemory();
    double value = 0.001;
    for (auto* numbers : {&memory.pitch, &memory.roll})
        for (double& number : *numbers) number = value += 0.001;
    for (TrailGround& ground : memory.ground)
        for (auto* numbers : {&ground.lowest, &ground.load, &ground.pressed})
            for (double& number : *numbers) number = value += 0.001;
    std::uint16_t cells = 0;
    for (TrailGround& ground : memory.ground)
        for (std::size_t i = 0; i < kBins; ++i) {
            ground.felt[i] = ++cells;
            ground.armHeight[i] = value += 0.001;
            ground.armSd[i] = value += 0.001;
        }
    EXPECT_EQ(memoryFrom(bytesOfMemory(memory)), memory);
    EXPECT_EQ(bytesOfMemory(memory).size(), 202U * 8U);
}

TEST(SessionMemory, OlderOnesFeltNothing)
{
    const TrailHistory memory = someMemory();
    EXPECT_EQ(memoryFrom(bytesOfMemory(memory).substr(0, 103U * 8U)), memory);
}

TEST(SessionMemory, RefusesWhatNoMemoryHas)
{
    const auto isRefused = [](const auto& change) {
        TrailHistory memory = someMemory();
        change(memory);
        return !memoryFrom(bytesOfMemory(memory));
    };
    EXPECT_FALSE(isRefused([](TrailHistory&) {}));
    EXPECT_TRUE(isRefused([](TrailHistory& m) { m.way = kTrailReach + 0.1; }));
    EXPECT_TRUE(isRefused([](TrailHistory& m) { m.way = -0.1; }));
    EXPECT_TRUE(isRefused([](TrailHistory& m) { m.presses = -1; }));
    EXPECT_TRUE(isRefused([](TrailHistory& m) { m.pitch[9] = std::nan(""); }));
    EXPECT_TRUE(isRefused([](TrailHistory& m) { m.ground[2].load[0] = -0.1; }));
    EXPECT_TRUE(isRefused([](TrailHistory& m) { m.ground[2].felt[0] = kAllCells + 1; }));
    EXPECT_TRUE(isRefused([](TrailHistory& m) { m.ground[2].armSd[10] = -0.01; }));
    EXPECT_TRUE(isRefused([](TrailHistory& m) { m.ground[1].lowest[0] = std::nan(""); }));
    EXPECT_TRUE(isRefused([](TrailHistory& m) { m.ground[1].lowest[0] = 1e9; }));
    EXPECT_TRUE(isRefused([](TrailHistory& m) { m.ground[0].pressed[0] = INFINITY; }));
    EXPECT_FALSE(memoryFrom(bytesOfMemory(someMemory()).substr(8)));
}

TEST_F(Session, refusesAStoredMemoryThatCannotBe)
{
    const std::string complaint =
        "row 1 of its table scene: a memory of the way is expected to hold 103 or 202 numbers";
    for (const char* memory :
         {"x'00'", "zeroblob(832)", "x''", "substr(memory, 1, 1608) || x'ffffffffffffffff'"}) {
        const std::string found =
            complaintsAfter(path, std::string("UPDATE scene SET memory = CAST(") + memory
                                      + " AS BLOB) WHERE id = 1");
        EXPECT_NE(found.find(complaint), std::string::npos) << memory << ": " << found;
        std::filesystem::remove(path);
    }
}

TEST_F(Session, refusesToWriteAMemoryOutOfRange)
{
    auto writer = SessionWriter::create(path, someStart());
    ASSERT_TRUE(writer) << writer.error().text;
    SceneRow scene = someScene(1, 0);
    scene.memory->pitch[0] = std::nan("");
    EXPECT_THROW((void)writer->add(scene), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
