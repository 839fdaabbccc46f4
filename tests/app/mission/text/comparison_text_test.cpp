// Tests what the operator reads about two models.
#include "app/mission/text/comparison_text.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

ModelComparison compared(double before, double after)
{
    ModelComparison c;
    c.before.near.mean = before;
    c.after.near.mean = after;
    c.before.near.coverage = 0.81;
    c.after.near.coverage = 0.79;
    c.scenes = c.tried = c.inFile = 300;
    c.nearDifference = Interval{};
    c.nearDifference->low = 0.001;
    c.nearDifference->high = 0.003;
    return c;
}

TEST(ComparisonTexts, nameTheModelWithTheSmallerError)
{
    const QString better = ComparisonWords::sentence(compared(0.020, 0.018));
    EXPECT_TRUE(better.contains("10 % smaller on 300 scenes")) << better.toStdString();
    EXPECT_TRUE(better.contains("79 % of the true heights, the old model's 81 %"));
    const QString worse = ComparisonWords::sentence(compared(0.020, 0.025));
    EXPECT_TRUE(worse.contains("25 % larger")) << worse.toStdString();
    const QString same = ComparisonWords::sentence(compared(0.020, 0.02005));
    EXPECT_TRUE(same.contains("the same mean error")) << same.toStdString();
}

TEST(ComparisonTexts, rowsHaveASignedDifference)
{
    const auto rows = ComparisonWords::rows(compared(0.020, 0.018));
    EXPECT_EQ(rows.at(1).before, "20.0");
    EXPECT_EQ(rows.at(1).after, "18.0");
    EXPECT_EQ(rows.at(1).difference, QString::fromUtf8("\u22122.0"));
    EXPECT_EQ(rows.at(3).before, "81");
}

TEST(ComparisonTexts, cautionAgainstChanceAndSeenScenes)
{
    ModelComparison c = compared(0.020, 0.018);
    EXPECT_EQ(ComparisonWords::caution(c), "");
    c.newTrained = 40;
    c.oldTrained = 300;
    EXPECT_EQ(
        ComparisonWords::caution(c),
        "The new model was trained on 40 of these 300 scenes or near copies, so its error looks "
        "too small. Choose scenes it has not seen. The old model was trained on 300 of these 300 "
        "scenes or near copies, so its error looks too small.");
    c.newTrained = c.oldTrained = 0;
    c.nearDifference->low = -0.004;
    EXPECT_TRUE(ComparisonWords::caution(c).contains(QString::fromUtf8("\u22124.0 … +3.0 mm")))
        << ComparisonWords::caution(c).toStdString();
    c.nearDifference.reset();
    EXPECT_TRUE(ComparisonWords::caution(c).contains("Too few drives"));
}

TEST(ComparisonTexts, cautionNamesScenesThatAreLeftOut)
{
    ModelComparison c = compared(0.020, 0.018);
    c.inFile = 900;
    c.scenes = 290;
    c.onlyAfter = 7;
    c.whyNot = Message::verbatim("no ground fits");
    const QString caution = ComparisonWords::caution(c);
    EXPECT_TRUE(caution.contains("300 of the file's 900 scenes")) << caution.toStdString();
    EXPECT_TRUE(caution.contains("10 scenes left out")) << caution.toStdString();
    EXPECT_TRUE(caution.contains("only the new 7): no ground fits")) << caution.toStdString();
}

}  // namespace
}  // namespace terratact
