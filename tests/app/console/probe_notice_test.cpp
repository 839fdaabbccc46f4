// Tests the notice of a probe proposal on other pages.
#include "app/console/probe_notice.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>

#include "app/console/main_window.h"
#include "tests/support/benches/console_bench.h"
#include "tests/support/gui.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/control/probe_card.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(Console, everyPageShowsTheApprovalExpiryOfAProposal)
{
    answerTime = 300.0;  // long, because the machine may be busy
    open(fastRobot(robot, 2.1));
    const QPushButton& terrain = *window->rail()->button(0);
    ASSERT_TRUE(readyToExplore());
    const QString plain = terrain.text();
    const int wide = window->rail()->width();
    proposeByKeyboard();
    EXPECT_FALSE(says("PROBE at")) << "the card asks";
    const QRegularExpression left("PROBE at 0\\.6 m\\? Refused in [0-9]:[0-9]{2}");
    const auto tells = [&] {
        for (const QLabel* label : window->findChildren<QLabel*>())
            if (label->isVisible() && left.match(label->text()).hasMatch()) return true;
        return false;
    };
    for (int page = 1; page < window->rail()->pages(); ++page) {
        if (window->rail()->button(page)->isHidden()) continue;
        QTest::keyClick(window.get(), window->rail()->keyOf(page));
        const std::string where = std::to_string(page);
        EXPECT_TRUE(eventually(tells)) << where;
        EXPECT_TRUE(terrain.text().contains(QRegularExpression("arm\\? [0-9]:[0-9]{2}"))) << where;
        EXPECT_TRUE(eventually([&] { return gui::cramped(*window).empty(); })) << where;
        EXPECT_EQ(window->rail()->width(), wide) << where;
    }
    QTest::keyClick(window.get(), Qt::Key_F3);
    ASSERT_TRUE(eventually(tells));
    if (const QString folder = qEnvironmentVariable("TERRATACT_PICTURES"); !folder.isEmpty())
        window->grab().save(folder + "/probe-asked-on-another-page.png");
    window->preferences().change([](Preferences& p) { p.forceThreshold += 0.5; });
    EXPECT_TRUE(eventually([&] { return says("proposed probe is void: F2 shows the reason"); }));
    EXPECT_FALSE(tells());
    EXPECT_TRUE(terrain.text().contains("arm: void")) << terrain.text().toStdString();
    EXPECT_EQ(window->rail()->width(), wide);
    QTest::mouseClick(window->rail()->button(0), Qt::LeftButton);
    EXPECT_TRUE(eventually([&] { return window->probeCard()->shown().has_value(); }));
    EXPECT_TRUE(eventually([&] { return !says("is void: F2"); }));
    QTest::keyClick(window.get(), Qt::Key_N);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(eventually([&] { return terrain.text() == plain; }))
        << terrain.text().toStdString();
    QTest::keyClick(window.get(), Qt::Key_F3);
    QTest::qWait(100);  // waits for an event that must not come
    EXPECT_FALSE(says("not answered in time")) << "it was answered";
}

TEST_F(Console, expiredProposalIsShownUntilTerrainPageOpens)
{
    answerTime = 2.0;
    open(fastRobot(robot, 2.1));
    ASSERT_TRUE(readyToExplore());
    QTest::keyClick(window.get(), Qt::Key_A);
    QTest::keyClick(window.get(), Qt::Key_F3);
    ASSERT_TRUE(reaches(AtemPhase::Presenting)) << "nobody has answered";
    EXPECT_TRUE(eventually([&] { return says("not answered in time and counts as refused"); }));
    QTest::keyClick(window.get(), Qt::Key_F4);
    QTest::qWait(100);
    EXPECT_TRUE(says("not answered in time")) << "on every page";
    QTest::keyClick(window.get(), Qt::Key_F2);
    EXPECT_TRUE(eventually([&] { return !says("The probe was not answered in time"); }));
    QTest::keyClick(window.get(), Qt::Key_F3);
    QTest::qWait(100);  // waits for an event that must not come
    EXPECT_FALSE(says("not answered in time")) << "it has been seen";
}

}  // namespace
}  // namespace terratact
