// Tests the list of a file's scenes.
#include "app/review/scenes_page.h"

#include <gtest/gtest.h>

#include <QLabel>

namespace terratact {
namespace {

TEST(ScenesPage, showsResultsAndSumsThemUp)
{
    std::vector<TwoTrackScene> scenes(3);
    scenes[1].run = "a <b>drive</b>";
    scenes[1].s.roll = 0.1;
    scenes[1].truth[0][4] = scenes[1].truth[1][4] = -0.2;
    SceneRows rows(scenes, nullptr);
    ScenesPage page(rows, nullptr);
    const auto text = [&](int row, int column) {
        return rows.index(row, column).data().toString();
    };
    EXPECT_EQ(text(1, SceneRows::Number), "2");
    EXPECT_EQ(text(1, SceneRows::Drive), "a <b>drive</b>");
    EXPECT_EQ(text(1, SceneRows::Roll), "+5.7°");
    EXPECT_EQ(text(1, SceneRows::Truth), "1 bins");
    EXPECT_EQ(text(1, SceneRows::Answer), "…");
    rows.setResult(1, {.verdict = StepVerdict::Blocked,
                       .error = SceneError{.bins = 1, .median = 0.012, .mean = 0.0154}});
    rows.setResult(2, {.trouble = Message::verbatim("no model")});
    EXPECT_EQ(text(1, SceneRows::Median), "12 mm");
    EXPECT_EQ(text(1, SceneRows::Mean), "15 mm");
    EXPECT_EQ(text(1, SceneRows::Answer), "BLOCKED");
    EXPECT_EQ(text(2, SceneRows::Answer), "no model");
    page.showSummary();
    EXPECT_EQ(page.summary()->text(), "2 of 3 scenes estimated now · 0 CLEAR, 1 BLOCKED, 0 CANNOT "
                                      "TELL · median error of the median scene: 12 mm");
    EXPECT_EQ(rows.nextWithout(1), 0U) << "around the end";
    rows.forget();
    EXPECT_EQ(rows.known(), 0U);
    EXPECT_EQ(text(1, SceneRows::Answer), "…");
}

}  // namespace
}  // namespace terratact
