#include "core/infer/estimate/two_track_estimate.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

TEST(OfBothSides, namesTheSideOfASentenceOfOne)
{
    const Message low = Message::verbatim("low"), high = Message::verbatim("high");
    EXPECT_EQ(english(ofBothSides({low, high}, {high}), "; "), "left: low; high");
    EXPECT_EQ(english(ofBothSides({low}, {high}), "; "), "left: low; right: high");
    EXPECT_TRUE(ofBothSides({}, {}).empty());
}

}  // namespace
}  // namespace terratact
