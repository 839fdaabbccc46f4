// Tests tables of a session.
#include <gtest/gtest.h>

#include <sstream>

#include "core/wire/can_codec.h"
#include "tests/support/sessions/session_files.h"

namespace terratact {
namespace {

TEST_F(SessionFiles, quotesTextsThatHoldSeparators)
{
    const std::string path = session("words.tts", [](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(EventRow{.id = 1,
                                        .kind = EventKind::Marker,
                                        .text = "a, \"b\"\nc\xFF\x01",
                                        .shown = "</script>"}));
    });
    EXPECT_NE(exported(path, "a.csv", ExportKind::Events).find("\"a, \"\"b\"\"\nc"),
              std::string::npos);
}

TEST_F(SessionFiles, aSignalThatWasNotMeasuredIsEmpty)
{
    const std::string path = session("lost.tts", [](SessionWriter& writer) {
        const CanFrame currents =
            pack({.kind = FrameKind::FrontCurrents, .values = {0.0, 1.5, 1.0, 1.0, 0.0}});
        ASSERT_TRUE(writer.add(FrameRow{.time = 1, .frame = currents}));
        ASSERT_TRUE(writer.add(FrameRow{.time = 2, .frame = pack({.kind = FrameKind::Attitude})}));
    });
    const std::string csv = exported(path, "a.csv", ExportKind::Signals);
    EXPECT_NE(csv.find(",,1.5,1,1,0,"), std::string::npos) << "the left current is missing";
    EXPECT_EQ(csv.find(",0,0,0,"), std::string::npos) << "Measured alone is 0";
}

/// Writes a session with an estimate of one plane and one of two sides.
std::string sessionOfSides(SessionFiles& files)
{
    return files.session("sides.tts", [](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
        for (const std::int64_t id : {1, 2}) {
            SceneRow scene = someScene(id, id * 1'000'000);
            scene.sideTruth = {{scene.truth.value(), Heights{}}};
            ASSERT_TRUE(writer.add(scene));
        }
        ASSERT_TRUE(writer.add(someEstimate(1, 3'000'000)));
        ASSERT_TRUE(writer.add(someSides(2, 4'000'000)));
    });
}

TEST_F(SessionFiles, bothSidesHaveRowsOfTheirOwn)
{
    const std::string csv = exported(sessionOfSides(*this), "a.csv", ExportKind::Estimates);
    const auto lines = [&csv](const std::string& part) {
        std::size_t count = 0;
        std::istringstream text(csv);
        for (std::string line; std::getline(text, line);) count += line.find(part) != line.npos;
        return count;
    };
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "__time,estimate,scene,role,method,bin_m,height_m,mean_m,sd_m,q10_m,q90_m,source,"
              "ceiling_m,rhat,ess,truth_m,touch,side");
    EXPECT_EQ(lines(",1,1,first,"), kBins);
    EXPECT_EQ(lines(",both"), kBins);
    EXPECT_EQ(lines(",left"), kBins);
    EXPECT_EQ(lines(",right"), kBins);
    EXPECT_EQ(lines("0.7,-0.24,"), 1U) << "the right side alone";
    EXPECT_EQ(lines(",0,not felt,right"), kBins - 1U) << "the truth of the right side";
}

}  // namespace
}  // namespace terratact
