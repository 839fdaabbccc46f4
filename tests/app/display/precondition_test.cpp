// Tests how preconditions of a command are shown and which of them decides.
#include "app/display/precondition.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

using Level = Precondition::Level;

TEST(Preconditions, everyOneHasALineWithItsMark)
{
    EXPECT_EQ(linesOf({{Level::Met, Message::verbatim("telemetry is live")},
                       {Level::Overridden, Message::verbatim("roll +6°")},
                       {Level::Doubtful, Message::verbatim("flippers differ")},
                       {Level::Missing, Message::verbatim("STOP is latched")}}),
              QString::fromUtf8("✔ telemetry is live\n! roll +6°\n! flippers differ\n"
                                "✘ STOP is latched"));
    EXPECT_EQ(linesOf({}), "");
}

TEST(Preconditions, theWorstDecidesAndTheFirstMissingIsNamed)
{
    EXPECT_EQ(worstOf({}), Level::Met);
    EXPECT_EQ(worstOf({{Level::Doubtful, Message::verbatim("a")},
                       {Level::Overridden, Message::verbatim("b")}}),
              Level::Doubtful);
    const QList<Precondition> some{{Level::Doubtful, Message::verbatim("a")},
                                   {Level::Missing, Message::verbatim("b")},
                                   {Level::Missing, Message::verbatim("c")},
                                   {Level::Met, Message::verbatim("d")}};
    EXPECT_EQ(worstOf(some), Level::Missing);
    EXPECT_EQ(firstMissing(some), Message::verbatim("b"));
    EXPECT_FALSE(firstMissing(some.mid(3)));
    EXPECT_FALSE(firstMissing({{Level::Doubtful, Message::verbatim("a")}}))
        << "it can be overridden";
}

}  // namespace
}  // namespace terratact
