// Tests MCAP exports of a session.
#include <gtest/gtest.h>

#include "core/wire/can_codec.h"
#include "tests/support/sessions/session_files.h"

namespace terratact {
namespace {

TEST_F(SessionFiles, escapesTextsOfAForeignFile)
{
    const std::string path = session("words.tts", [](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(EventRow{.id = 1,
                                        .kind = EventKind::Marker,
                                        .text = "a, \"b\"\nc\xFF\x01",
                                        .shown = "</script>"}));
    });
    EXPECT_NE(exported(path, "a.mcap")
                  .find(R"("text":"a, \"b\"\u000ac)"
                        "\xEF\xBF\xBD"
                        R"(\u0001")"),
              std::string::npos);
}

TEST_F(SessionFiles, schemasHaveOnlyWhatViewersRead)
{
    const std::string mcap =
        exported(session("a.tts",
                         [](SessionWriter& writer) {
                             ASSERT_TRUE(writer.add(EventRow{.id = 1, .kind = EventKind::Marker}));
                         }),
                 "a.mcap");
    EXPECT_NE(mcap.find(R"("front_left_force":{"type":"array","items":{"type":"number"}})"),
              std::string::npos);
    EXPECT_EQ(mcap.find(R"("type":[)"), std::string::npos) << "Foxglove refuses a list of types";
    EXPECT_NE(mcap.find(R"("signals":{"type":"object","properties":{})"), std::string::npos);
}

TEST_F(SessionFiles, aSignalThatWasNotMeasuredIsNull)
{
    const std::string path = session("lost.tts", [](SessionWriter& writer) {
        const CanFrame currents =
            pack({.kind = FrameKind::FrontCurrents, .values = {0.0, 1.5, 1.0, 1.0, 0.0}});
        ASSERT_TRUE(writer.add(FrameRow{.time = 1, .frame = currents}));
    });
    const std::string mcap = exported(path, "a.mcap", ExportKind::Frames);
    EXPECT_NE(mcap.find(R"("signals":{"Left":null,"Right":1.5,)"), std::string::npos);
}

TEST_F(SessionFiles, eachSideHasAChannelIfThereAreTwo)
{
    const auto fill = [](bool two) {
        return [two](SessionWriter& writer) {
            ASSERT_TRUE(
                writer.add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
            ASSERT_TRUE(writer.add(someScene(1, 1'000'000)));
            ASSERT_TRUE(writer.add(two ? someSides(1, 2'000'000) : someEstimate(1, 2'000'000)));
        };
    };
    const std::string plane = exported(session("plane.tts", fill(false)), "plane.mcap");
    EXPECT_NE(plane.find("/estimate"), std::string::npos);
    EXPECT_EQ(plane.find("/estimate/"), std::string::npos);
    const std::string sides = exported(session("sides.tts", fill(true)), "sides.mcap");
    for (const char* const topic : {"/estimate/left", "/estimate/right"})
        EXPECT_NE(sides.find(topic), std::string::npos) << topic;
    EXPECT_NE(sides.find("the right side alone"), std::string::npos) << "a warning of that side";
    EXPECT_EQ(counts.others, 1U);
}

}  // namespace
}  // namespace terratact
