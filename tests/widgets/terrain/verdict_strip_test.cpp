#include "widgets/terrain/verdict_strip.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>

#include <utility>

#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/spoken.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

struct Strip : testing::Test {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }
    Strip()
    {
        strip.resize(650, 80);
        gui::showActive(strip);
        QObject::connect(&strip, &VerdictStrip::limitChosen, [this](double m) { chosen << m; });
    }
    VerdictStrip strip;
    QList<double> chosen;
};

Verdict verdict(StepVerdict stepVerdict, double p)
{
    return {.stepVerdict = stepVerdict,
            .step = {p, 0.013},
            .likeliest = 8,
            .likeliestP = 0.5,
            .withheldFor = {},
            .toHorizon = {}};
}

TEST_F(Strip, answersInAWordWithAShape)
{
    strip.setVerdict(verdict(StepVerdict::Clear, 0.01));
    EXPECT_EQ(strip.badge(), QStringLiteral("✔ CLEAR"));
    strip.setVerdict(verdict(StepVerdict::Blocked, 0.99));
    EXPECT_EQ(strip.badge(), QStringLiteral("✘ BLOCKED"));
    EXPECT_EQ(strip.question(), QStringLiteral("P(step > 0.10 m ahead) = 0.99 ± 0.01"));
    EXPECT_TRUE(strip.reason().contains(QStringLiteral("at +0.5 … +0.6 m (0.50)")));
    strip.setNothing("the robot has moved");
    EXPECT_EQ(strip.badge(), QStringLiteral("NO VERDICT"));
    EXPECT_EQ(strip.reason(), QStringLiteral("the robot has moved"));
}

TEST_F(Strip, clearNamesTheBinsThatAreNotFelt)
{
    Verdict v = verdict(StepVerdict::Clear, 0.01);
    strip.setVerdict(v);
    EXPECT_FALSE(strip.reason().contains("not felt"));
    v.unfelt = {9, 10};
    strip.setVerdict(v);
    EXPECT_TRUE(strip.reason().contains("not felt: 0.6 m, 0.7 m")) << strip.reason().toStdString();
    v.unfelt = {10};
    strip.setVerdict(v);
    EXPECT_TRUE(strip.reason().endsWith("not felt: 0.7 m")) << strip.reason().toStdString();
}

TEST_F(Strip, withheldVerdictDoesNotLeadWithItsProbability)
{
    Verdict v = verdict(StepVerdict::CannotTell, 0.99);
    const auto isBold = [this] {
        return strip.findChild<QLabel*>("verdictQuestion")->fontInfo().bold();
    };
    strip.setVerdict(v, "probe at 0.4 m");
    EXPECT_TRUE(isBold());
    EXPECT_TRUE(strip.reason().contains("probe at 0.4 m"));
    v.withheldFor = {WithholdReason::Stale};
    strip.setVerdict(v, "probe at 0.4 m");
    EXPECT_FALSE(isBold());
    EXPECT_EQ(strip.question(), QStringLiteral("(P(step > 0.10 m ahead) = 0.99 ± 0.01)"));
    EXPECT_FALSE(strip.reason().contains("probe")) << "what does not count asks for no arm";
    strip.setNothing({});
    EXPECT_TRUE(isBold());
}

TEST_F(Strip, theBadgeHasTheColoursOfItsAnswerInEveryTheme)
{
    auto* const badge = strip.findChild<QLabel*>(QStringLiteral("verdictBadge"));
    ASSERT_TRUE(badge);
    const auto expectColours = [badge](const Fill& fill) {
        const QImage image = gui::painted(*badge);
        const int pixels = image.width() * image.height();
        EXPECT_GT(gui::pixelsOf(image, fill.area), pixels / 2) << badge->text().toStdString();
        EXPECT_GT(gui::pixelsOf(image, fill.text), pixels / 200) << badge->text().toStdString();
    };
    for (const ThemeName name : {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast}) {
        applyLook(*qApp, name);
        strip.setVerdict(verdict(StepVerdict::Clear, 0.01));
        expectColours(theme().clear);
        strip.setVerdict(verdict(StepVerdict::Blocked, 0.99));
        expectColours(theme().blocked);
        strip.setVerdict(verdict(StepVerdict::CannotTell, 0.5));
        expectColours(theme().open);
        strip.setNothing("the robot has moved");
        expectColours(theme().off);
    }
    applyLook(*qApp);
}

TEST_F(Strip, namesWhatIsMissingForAVerdict)
{
    strip.setVerdict(verdict(StepVerdict::CannotTell, 0.95));
    EXPECT_TRUE(strip.reason().contains("not decided; most likely at"))
        << strip.reason().toStdString();
    EXPECT_TRUE(VerdictStrip::whyOf(verdict(StepVerdict::CannotTell, 0.95))
                    .contains("not decided (CLEAR below 0.05, BLOCKED above 0.95); most likely"));
}

TEST_F(Strip, neverClaimsToBeWithoutError)
{
    Verdict v = verdict(StepVerdict::Clear, 0.01);
    v.step.monteCarloSd = 0.0049;
    strip.setVerdict(v);
    EXPECT_EQ(strip.question(), QStringLiteral("P(step > 0.10 m ahead) = 0.01 ± < 0.01"));
    v.step.monteCarloSd = 0.0051;
    strip.setVerdict(v);
    EXPECT_EQ(strip.question(), QStringLiteral("P(step > 0.10 m ahead) = 0.01 ± 0.01"));
}

TEST_F(Strip, givesTheReasonWhyAVerdictIsWithheld)
{
    Verdict v = verdict(StepVerdict::CannotTell, 0.99);
    v.withheldFor = {WithholdReason::NotConverged, WithholdReason::Roll};
    strip.setVerdict(v, "a probe at 0.6 m: 0.98 → 0.31 bit");
    EXPECT_EQ(strip.badge(), QStringLiteral("? CANNOT TELL"));
    for (const char* part : {"withheld", "converged", "rolls"})
        EXPECT_TRUE(strip.reason().contains(QString::fromUtf8(part))) << part;
    EXPECT_FALSE(strip.reason().contains("likeliest"));
}

TEST_F(Strip, clearingTheVerdictClearsItsTip)
{
    Verdict v = verdict(StepVerdict::CannotTell, 0.99);
    v.withheldFor = {WithholdReason::Stale};
    strip.setVerdict(v);
    const QLabel* reason = nullptr;
    for (const QLabel* label : strip.findChildren<QLabel*>())
        if (label->text() == strip.reason()) reason = label;
    ASSERT_TRUE(reason);
    EXPECT_TRUE(reason->toolTip().contains("the robot may have moved"));
    strip.setNothing("explore the terrain");
    EXPECT_EQ(reason->toolTip(), "");
}

/// Records what a widget announces to a screen reader.
class Announcements final : public QObject {
public:
    explicit Announcements(const VerdictStrip& strip)
    {
        for (QLabel* label : strip.findChildren<QLabel*>()) label->installEventFilter(this);
    }
    QStringList consume() { return std::exchange(said_, {}); }

private:
    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() == kAnnounced) said_ << qobject_cast<QLabel*>(object)->text();
        return false;
    }
    QStringList said_;
};

TEST_F(Strip, sameVerdictWithAnotherReasonIsAnnounced)
{
    Announcements announcements(strip);
    const Verdict undecided = verdict(StepVerdict::CannotTell, 0.5);
    Verdict withheld = undecided;
    withheld.withheldFor = {WithholdReason::TelemetryGap};
    strip.setVerdict(undecided);
    EXPECT_EQ(announcements.consume(), QStringList{QStringLiteral("? CANNOT TELL")});
    strip.setVerdict(undecided);
    EXPECT_EQ(announcements.consume(), QStringList());
    strip.setVerdict(withheld);
    EXPECT_EQ(announcements.consume(),
              QStringList{"withheld: the link was lost, the robot may have moved"});
    strip.setVerdict(withheld);
    EXPECT_EQ(announcements.consume(), QStringList()) << "once";
    strip.setVerdict(undecided);
    EXPECT_EQ(announcements.consume().size(), 1);
}

TEST_F(Strip, theLimitMovesByACentimetreWithinItsRange)
{
    QTest::mouseClick(strip.raiseButton(), Qt::LeftButton);
    QTest::mouseClick(strip.raiseButton(), Qt::LeftButton);
    QTest::mouseClick(strip.lowerButton(), Qt::LeftButton);
    ASSERT_EQ(chosen.size(), 3);
    EXPECT_NEAR(chosen[1], 0.12, 1e-12);
    EXPECT_NEAR(strip.limit(), 0.11, 1e-12);
    for (int i = 0; i < 100; ++i) QTest::mouseClick(strip.lowerButton(), Qt::LeftButton);
    EXPECT_NEAR(strip.limit(), VerdictStrip::kMinLimit, 1e-12);
    EXPECT_FALSE(strip.lowerButton()->isEnabled());
    for (const double hostile : gui::kHostile) {
        strip.setLimit(hostile);
        EXPECT_GE(strip.limit(), VerdictStrip::kMinLimit);
        EXPECT_LE(strip.limit(), VerdictStrip::kGreatestLimit);
    }
}

TEST_F(Strip, nothingIsCutInTheNarrowestWindow)
{
    strip.setVerdict(verdict(StepVerdict::CannotTell, 0.71), "probe at 0.4 m: 0.87 → 0.53 bit");
    QCoreApplication::processEvents();
    for (const std::string& text : gui::cutText(strip)) ADD_FAILURE() << text;
}

TEST_F(Strip, survivesHostileNumbers)
{
    for (const double hostile : gui::kHostile) {
        strip.setVerdict(verdict(StepVerdict::CannotTell, hostile));
        EXPECT_FALSE(gui::painted(strip).isNull());
    }
}

}  // namespace
}  // namespace terratact
