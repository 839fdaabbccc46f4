// Tests the probe proposal: shown on every page, approved, refused, expired.
#include "app/console/main_window.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QPushButton>
#include <QRegularExpression>
#include <atomic>
#include <utility>
#include <vector>

#include "app/display/format.h"
#include "app/start/language.h"
#include "tests/support/benches/console_bench.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/held_estimate.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/probe_card.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(Console, lettingGoEarlyApprovesNothing)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    window->probeCard()->approveButton()->setHoldTime(100000);
    QTest::keyPress(window.get(), Qt::Key_Space);
    EXPECT_TRUE(window->probeCard()->approveButton()->isHeld());
    QTest::keyRelease(window.get(), Qt::Key_Space);
    EXPECT_TRUE(eventually([&] { return !window->probeCard()->approveButton()->isHeld(); }));
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe);
    QTest::keyClick(window.get(), Qt::Key_N);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_FALSE(window->exploration().state().probed);
}

TEST_F(Console, aHoldThatIsNotCompleteInTimeApprovesNothing)
{
    answerTime = 2.0;
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    window->probeCard()->approveButton()->setHoldTime(100000);
    QTest::keyPress(window.get(), Qt::Key_Space);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(window->exploration().state().approvalExpired);
    EXPECT_FALSE(window->exploration().state().probed);
    EXPECT_TRUE(eventually([&] { return says("no answer in time"); }));
    EXPECT_FALSE(window->probeCard()->approveButton()->isHeld());
    QTest::keyRelease(window.get(), Qt::Key_Space);
    EXPECT_FALSE(window->exploration().state().probed);
}

TEST_F(Console, themeAndFontChangeDuringAProposal)
{
    open(fastRobot(robot, 2.1));
    window->setRoom(QSize(1920, 1080));
    window->resize(1920, 1080);
    proposeByKeyboard();
    const auto asked = window->exploration().proposal()->id;
    QTest::keyClick(window.get(), Qt::Key_5, Qt::ControlModifier);
    EXPECT_EQ(lookInForce().theme, ThemeName::NightRed);
    for (int i = 0; i < 5; ++i) QTest::keyClick(window.get(), Qt::Key_Plus, Qt::ControlModifier);
    EXPECT_GE(lookInForce().fontScale, 140);
    EXPECT_EQ(window->exploration().proposal()->id, asked);
    ASSERT_TRUE(eventually([&] { return window->probeCard()->asks(); }));
    ASSERT_TRUE(eventually([&] {  // after drawing in this font
        QTest::keyPress(window.get(), Qt::Key_Space);
        if (window->probeCard()->approveButton()->isHeld()) return true;
        QTest::keyRelease(window.get(), Qt::Key_Space);
        return false;
    }));
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(window->exploration().state().probed);
    QTest::keyRelease(window.get(), Qt::Key_Space);
}

/// Returns stepEstimate with draws: at +0.6 and +0.7 m the ground is high or low, independently.
TerrainEstimate withDraws(TerrainEstimate e)
{
    for (int d = 0; d < 400; ++d) {
        Heights h = e.height;
        h[9] += d % 2 == 0 ? 0.09 : -0.09;
        h[10] += d % 4 < 2 ? 0.08 : -0.08;
        e.draws.push_back(h);
    }
    return e;
}

TEST_F(Console, theVerdictFollowsTheLimitAndTheProbeThatIsChosen)
{
    open(fastRobot(robot, 2.1), [] {
        return Result<LoadedModel>(
            LoadedModel{.estimate =
                            [](const EstimateRequest& request, const Watch&) {
                                TerrainEstimate e = withDraws(stepEstimate());
                                e.settings = request.settings;
                                return equalSides(e);
                            },
                        .name = "fake.ttm",
                        .details = {}});
    });
    EXPECT_EQ(window->verdict()->badge(), QStringLiteral("NO VERDICT"));
    proposeByKeyboard();
    ASSERT_TRUE(
        eventually([&] { return window->verdict()->badge() == QStringLiteral("✘ BLOCKED"); }));
    QTest::keyClick(window.get(), Qt::Key_F3);
    EXPECT_TRUE(eventually([&] { return says(QStringLiteral("✘ BLOCKED · P(step")); }));
    QTest::keyClick(window.get(), Qt::Key_F2);
    for (int i = 0; i < 40; ++i) QTest::keyClick(window.get(), Qt::Key_PageUp);
    EXPECT_TRUE(
        eventually([&] { return window->verdict()->badge() == QStringLiteral("✔ CLEAR"); }));
    EXPECT_NEAR(window->exploration().options().stepLimit, 0.5, 1e-9);

    ASSERT_TRUE(eventually([&] {
        return window->verdict()->reason().contains("probe at")
            && window->exploration().proposal()->stepLimit == window->verdict()->limit();
    })) << "the question of the probe is that of the verdict";
    const auto first = window->exploration().proposal();
    ASSERT_TRUE(first && first->worth && !first->others.empty());
    ASSERT_TRUE(eventually([&] { return window->probeCard()->shown() == first->id; }));
    QTest::keyClick(window.get(), Qt::Key_1);
    const auto chosen = window->exploration().proposal();
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->bin, first->others[0].bin);
    EXPECT_NE(chosen->id, first->id) << "an answer to the first must not count for the second";
    EXPECT_EQ(chosen->worth, first->others[0]);
    ASSERT_TRUE(eventually([&] {
        return window->probeCard()->approveButton()->text().contains(format::binName(chosen->bin));
    }));

    ASSERT_TRUE(eventually([&] { return window->probeCard()->shown() == chosen->id; }));
    QTest::keyClick(window.get(), Qt::Key_N);
    ASSERT_TRUE(eventually([&] { return window->probeCard()->showsWorth(); }))
        << "what it would have bought";
    EXPECT_FALSE(window->probeCard()->asks());
    EXPECT_TRUE(window->verdict()->reason().contains("probe at"));
    QTest::keyClick(window.get(), Qt::Key_PageDown);
    EXPECT_TRUE(eventually([&] {
        const auto best = window->exploration().bestProbe();
        return best && best->stepLimit == window->verdict()->limit();
    })) << "by the limit of now";
}

TEST_F(Console, railShowsExplorationPhaseOnOtherPages)
{
    answerTime = 300.0;
    std::atomic<bool> held = true;
    open(fastRobot(robot, 2.1), [&held] {
        LoadedModel model = madeUp();
        model.estimate = [&held, estimate = model.estimate](const EstimateRequest& request,
                                                            const Watch& watch) {
            waitWhile([&held] { return held.load(); }, watch);
            return estimate(request, watch);
        };
        return Result<LoadedModel>(std::move(model));
    });
    ASSERT_TRUE(readyToExplore());
    const QPushButton& terrain = *window->rail()->button(0);
    const QString plain = terrain.text();
    const int wide = window->rail()->width();
    const auto tells = [&](const char* what) {
        const QRegularExpression words(QLatin1String(what) + QLatin1Char('$'));
        EXPECT_TRUE(eventually([&] { return terrain.text().contains(words); }))
            << what << ": " << terrain.text().toStdString();
        EXPECT_EQ(window->rail()->width(), wide) << what;
        EXPECT_EQ(gui::cutWhenSettled(*window->rail()), std::vector<std::string>()) << what;
    };
    QTest::keyClick(window.get(), Qt::Key_A);
    EXPECT_TRUE(reaches(AtemPhase::Estimating));
    EXPECT_TRUE(eventually([&] { return says("Estimating"); }));
    EXPECT_EQ(terrain.text(), plain) << "the card says it";
    QTest::keyClick(window.get(), Qt::Key_F3);
    tells("estimating");
    held = false;
    tells("arm\\? [0-9]:[0-9]{2}");
    QTest::keyClick(window.get(), Qt::Key_F2);
    ASSERT_TRUE(eventually([&] { return window->probeCard()->shown().has_value(); }));
    QTest::keyPress(window.get(), Qt::Key_Space);
    ASSERT_TRUE(reaches(AtemPhase::Probing));
    QTest::keyRelease(window.get(), Qt::Key_Space);
    QTest::keyClick(window.get(), Qt::Key_F5);
    tells("probe 0:[0-9]{2}");
    tells("result");
    QTest::keyClick(window.get(), Qt::Key_F2);
    EXPECT_TRUE(eventually([&] { return terrain.text() == plain; }));
}

TEST_F(Console, railKeepsItsWidthForEveryPhaseAndLanguage)
{
    for (const char* language : {"en", "cs", "de"}) {
        window.reset();
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
        openScripted();
        const int wide = window->rail()->width();
        for (const char* word :
             {"halting", "pressing", "estimating", "probe", "result", "failed"}) {
            const bool timed = std::string_view(word) == "probe";
            const QString time = timed ? QStringLiteral(" 0:44") : QString();
            window->rail()->setNote(0, ProbeNotice::tr(word) + time, false);
            QTest::qWait(20);
            EXPECT_EQ(window->rail()->width(), wide) << language << ": " << word;
        }
    }
    window.reset();
    installLanguage(*qApp, "en");
}

}  // namespace
}  // namespace terratact
