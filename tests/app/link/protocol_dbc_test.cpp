// Tests that the robot's DBC file equals the protocol of this program.
#include "app/link/protocol_dbc.h"

#include <gtest/gtest.h>

#include "app/runtime/resources.h"
#include "core/wire/frame_layout.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(ProtocolDbc, equalsTheProtocolOfThisProgram)
{
    const auto said = readProtocolDbc(resourcePath("dbc/terratact.dbc"));
    ASSERT_TRUE(said) << said.error().text;
    ASSERT_EQ(said->size(), kFrameKinds);
    for (std::size_t i = 0; i < kFrameKinds; ++i)
        EXPECT_EQ((*said)[i].name, layoutOf(static_cast<FrameKind>(i)).name);
}

TEST(ProtocolDbc, ofAnotherVersionIsRefused)
{
    const TemporaryDirectory directory;
    const std::string whole = contentOf(TERRATACT_SOURCE_DIR "/resources/dbc/terratact.dbc");
    const std::pair<std::string, std::string> changes[]{
        {"SG_ Pitch : 24|16", "SG_ Pitch : 25|15"},
        {"SG_ Pitch : 24|16@1- (0.0001", "SG_ Pitch : 24|16@1- (0.0002"},
        {"SG_ Pitch : 24|16", "SG_ Pitch : 24|15"},
        {"SG_ Pitch :", "SG_ Tilt :"},
        {"BO_ 34 Attitude", "BO_ 334 Attitude"},
        {"BO_ 34 Attitude", "BO_ 34 Attitudes"},
    };
    for (const auto& [from, to] : changes) {
        std::string text = whole;
        text.replace(text.find(from), from.size(), to);
        const std::string path = directory.write("terratact.dbc", text);
        EXPECT_TRUE(refused(readProtocolDbc(path), path, {"Attitude", "install"})) << to;
    }
}

}  // namespace
}  // namespace terratact
