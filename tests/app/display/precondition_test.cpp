// Tests how preconditions of a command are shown and which of them decides.
#include "app/display/precondition.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

using Level = Precondition::Level;

TEST(Preconditions, everyOneHasALineWithItsMark)
{
    EXPECT_EQ(linesOf({{Level::Met, "telemetry is live"},
                       {Level::Overridden, "roll +6°"},
                       {Level::Doubtful, "flippers differ"},
                       {Level::Missing, "STOP is latched"}}),
              QString::fromUtf8("✔ telemetry is live\n! roll +6°\n! flippers differ\n"
                                "✘ STOP is latched"));
    EXPECT_EQ(linesOf({}), "");
}

TEST(Preconditions, theWorstDecidesAndTheFirstMissingIsNamed)
{
    EXPECT_EQ(worstOf({}), Level::Met);
    EXPECT_EQ(worstOf({{Level::Doubtful, "a"}, {Level::Overridden, "b"}}), Level::Doubtful);
    const QList<Precondition> some{
        {Level::Doubtful, "a"}, {Level::Missing, "b"}, {Level::Missing, "c"}, {Level::Met, "d"}};
    EXPECT_EQ(worstOf(some), Level::Missing);
    EXPECT_EQ(firstMissing(some), "b");
    EXPECT_EQ(firstMissing(some.mid(3)), "");
    EXPECT_EQ(firstMissing({{Level::Doubtful, "a"}}), "") << "it can be overridden";
}

}  // namespace
}  // namespace terratact
