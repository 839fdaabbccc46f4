// Tests two cursors in a session.
#include "app/review/export/review_difference.h"

#include <gtest/gtest.h>

#include "app/review/review_window.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST(ReviewDifference, hasBothSidesWhereTheyChangedByOtherAmounts)
{
    ReviewMoment a{.measurement = Measurement{}},
        b{.time = 1'000'000'000, .measurement = Measurement{}};
    b.measurement->frontLeft = b.measurement->frontRight = 0.1;
    EXPECT_TRUE(differenceText(a, b).contains("front +5.7°")) << differenceText(a, b).toStdString();
    b.measurement->frontRight = -0.1;
    a.measurement->sides.left[5] = 1.0;
    b.measurement->sides.left[5] = 3.5;
    const QString words = differenceText(a, b);
    EXPECT_TRUE(words.contains("front left +5.7° right -5.7°")
                || words.contains("front left +5.7° right −5.7°"))
        << words.toStdString();
    EXPECT_TRUE(words.contains("forces left -- -- -- -- -- +2.5 right --")) << words.toStdString();
    const QString csv = numbersCsv(b);
    EXPECT_TRUE(csv.section('\n', 0, 0).endsWith("front_right_force_6_n"));
    EXPECT_EQ(csv.section('\n', 0, 0).count(','), csv.section('\n', 1, 1).count(','));
    EXPECT_EQ(numbersCsv({}).section('\n', 1, 1).count(','), csv.section('\n', 0, 0).count(','));
}

TEST(ReviewDifference, aMissingCurrentIsAnEmptyNumber)
{
    ReviewMoment moment{.measurement = Measurement{}};
    setCurrents(*moment.measurement, {std::nullopt, 2.0, 1.0, 3.0});
    const QString csv = numbersCsv(moment);
    EXPECT_EQ(csv.section('\n', 0, 0).section(',', 8, 8), "front_left_a");
    EXPECT_EQ(csv.section('\n', 1, 1).section(',', 8, 11), ",2,1,3");
}

TEST_F(ReviewOf, twoCursorsLoopAndShowTheDifference)
{
    record();
    open();
    window->goTo(1.0);
    press(Qt::Key_A);
    window->goTo(1.5);
    press(Qt::Key_B);
    EXPECT_TRUE(window->differenceLabel()->text().contains("+0.500"));
    press(Qt::Key_P);
    EXPECT_TRUE(window->player().loops());
    press(Qt::Key_L);
    for (int n = 0; n < 10; ++n) {
        window->poll(0.2);
        EXPECT_GE(now(), 1.0);
        EXPECT_LE(now(), 1.5);
    }
    press(Qt::Key_K);
    window->goTo(1.5);
    press(Qt::Key_B);
    EXPECT_FALSE(window->player().b());
}

}  // namespace
}  // namespace terratact
