#include "widgets/terrain/readings/verdict_strip.h"

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
    EXPECT_TRUE(strip.reason().contains(QStringLiteral("at +0.5 … +0.6 m (P 0.50)")));
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

TEST_F(Strip, clearOverSpannedGroundSaysHowFarItIsFelt)
{
    Verdict v = verdict(StepVerdict::Clear, 0.01);
    v.touchRecorded = true;
    v.horizon = v.feltTo = 0.55;
    strip.setVerdict(v);
    EXPECT_TRUE(strip.reason().startsWith("felt to +0.55 m ahead")) << strip.reason().toStdString();
    v.feltTo = 0.35;
    v.shortfall = Shortfall::Spanned;
    v.unfelt = {7, 9};
    strip.setVerdict(v);
    EXPECT_EQ(strip.reason(), QStringLiteral("felt to +0.35 m only, spanned to +0.55 m, risk below "
                                             "5 %; not felt: 0.4 m, 0.6 m"));
    v.bounded = {7};
    strip.setVerdict(v);
    EXPECT_EQ(strip.reason(), QStringLiteral("felt to +0.35 m only, spanned to +0.55 m, risk below "
                                             "5 %; bounded: 0.4 m; not felt: 0.6 m"));
    v.unfelt.clear();
    v.bounded.clear();
    v.feltTo = 0.25;  // behind the first bin ahead
    strip.setVerdict(v);
    EXPECT_EQ(strip.reason(),
              QStringLiteral("nothing ahead is felt, spanned to +0.55 m, risk below 5 %"));
}

TEST_F(Strip, aShortHorizonCountsFeltBinsOnly)
{
    Verdict v = verdict(StepVerdict::CannotTell, 0.5);
    v.touchRecorded = true;
    v.horizon = 0.45;
    v.feltTo = 0.35;
    v.shortfall = Shortfall::ShortHorizon;
    EXPECT_TRUE(VerdictStrip::brieflyOf(v, true).contains("felt to +0.35 m only"))
        << VerdictStrip::brieflyOf(v, true).toStdString();
    v.feltTo = 0.25;
    EXPECT_TRUE(VerdictStrip::brieflyOf(v, true).contains("nothing ahead is felt"))
        << VerdictStrip::brieflyOf(v, true).toStdString();
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
    v.step.p = 0.996;
    strip.setVerdict(v);
    EXPECT_EQ(strip.question(), QStringLiteral("P(step > 0.10 m ahead): more than 0.99"));
    v.step.p = 0.994;
    strip.setVerdict(v);
    EXPECT_EQ(strip.question(), QStringLiteral("P(step > 0.10 m ahead) = 0.99 ± 0.01"));
    v.step.p = 0.0;
    strip.setVerdict(v);
    EXPECT_EQ(strip.question(), QStringLiteral("P(step > 0.10 m ahead): less than 0.01"));
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
        EXPECT_LE(strip.limit(), VerdictStrip::kMaxLimit);
    }
}

/// Returns BLOCKED at the left and CLEAR at the right.
TwoTrackVerdict leftBlocked()
{
    TwoTrackVerdict both;
    both.side = {verdict(StepVerdict::Blocked, 0.99), verdict(StepVerdict::Clear, 0.02)};
    both.side[0].likeliest = 6;
    both.side[1].touchRecorded = true;
    both.side[1].horizon = 0.55;
    both.either = {0.98, 0.01};
    both.both = StepVerdict::Blocked;
    return both;
}

TEST_F(Strip, onePlaneReadsAsBefore)
{
    const Verdict plane = verdict(StepVerdict::CannotTell, 0.5);
    strip.setVerdict(plane, "probe");
    const QStringList before{strip.badge(), strip.question(), strip.reason()};
    strip.setVerdict(leftBlocked());
    strip.setVerdict(equalSides(plane), "probe");
    EXPECT_EQ((QStringList{strip.badge(), strip.question(), strip.reason()}), before);
}

TEST_F(Strip, namesTheAnswerOfEachSide)
{
    strip.resize(1000, 80);
    strip.setVerdict(leftBlocked());
    QCoreApplication::processEvents();
    EXPECT_EQ(strip.badge(), QStringLiteral("✘ BLOCKED"));
    EXPECT_EQ(strip.question(),
              QStringLiteral("left ✘ BLOCKED at +0.4 m · right ✔ CLEAR to +0.55 m"));
    EXPECT_EQ(strip.reason(), QStringLiteral("P(step > 0.10 m, L or R) = 0.98 ± 0.01"));
    auto* const question = strip.findChild<QLabel*>("verdictQuestion");
    EXPECT_EQ(question->accessibleName(), "Verdict of each side");
    strip.resize(650, 80);
    QCoreApplication::processEvents();
    EXPECT_EQ(strip.question(), QStringLiteral("L ✘ BLOCKED 0.4 · R ✔ CLEAR 0.55 m"));
    EXPECT_EQ(question->accessibleDescription(),
              QStringLiteral("left ✘ BLOCKED at +0.4 m · right ✔ CLEAR to +0.55 m"));
    for (const std::string& text : gui::cutText(strip))
        ADD_FAILURE() << text << question->width() << " of "
                      << question->fontMetrics().horizontalAdvance(strip.question());
    strip.setVerdict(verdict(StepVerdict::Blocked, 0.99));
    EXPECT_EQ(question->accessibleName(), "Probability of a step ahead");
}

TEST_F(Strip, clearReachesToTheNearerHorizon)
{
    TwoTrackVerdict both = leftBlocked();
    both.side[0] = both.side[1];
    both.side[1].horizon = 0.75;
    both.both = StepVerdict::Clear;
    strip.setVerdict(both);
    EXPECT_EQ(strip.badge(), QStringLiteral("✔ CLEAR\nto +0.55 m"));
    both.side[1].horizon = 0.55;
    both.side[1].step.p = 0.01;
    strip.setVerdict(both);
    EXPECT_EQ(strip.question(),
              QStringLiteral("P(step > 0.10 m) L less than 0.01, R less than 0.01"))
        << "both sides say the same";
}

TEST_F(Strip, givesTheReasonThatNoSideGives)
{
    TwoTrackVerdict both = leftBlocked();
    both.side[0] = both.side[1];
    both.side[0].step.p = 0.03;
    both.both = StepVerdict::CannotTell;
    strip.setVerdict(both);
    EXPECT_EQ(strip.question(), QStringLiteral("each side ✔ CLEAR to +0.55 m"));
    EXPECT_TRUE(strip.reason().contains("each side alone is clear, both together are not"))
        << strip.reason().toStdString();
    both.crossSlope = {.steepest = 0.8, .bin = 8, .limit = 0.77, .beyond = {0.4, 0.01}};
    strip.setVerdict(both);
    EXPECT_TRUE(strip.reason().contains(QStringLiteral("cross slope 46° of 54°, L up")))
        << strip.reason().toStdString();
    EXPECT_TRUE(strip.reason().contains("the cross slope ahead is not decided"));
    both.both = StepVerdict::Blocked;
    strip.setVerdict(both);
    EXPECT_TRUE(strip.reason().contains("may tip the robot over"));
}

TEST_F(Strip, aWithheldVerdictNamesTheSideOfItsReason)
{
    TwoTrackVerdict both = leftBlocked();
    for (Verdict& side : both.side) side.stepVerdict = StepVerdict::CannotTell;
    both.side[0].withheldFor = {WithholdReason::UnlikeTraining};
    both.both = StepVerdict::CannotTell;
    strip.setVerdict(both, "probe left at 0.4 m");
    EXPECT_EQ(strip.question(), QStringLiteral("(P(step > 0.10 m, L or R) = 0.98 ± 0.01)"));
    EXPECT_TRUE(strip.reason().startsWith("L: withheld")) << strip.reason().toStdString();
    EXPECT_FALSE(strip.reason().contains("probe"));
    both.side[1].withheldFor = both.side[0].withheldFor;
    strip.setVerdict(both);
    EXPECT_TRUE(strip.reason().startsWith("withheld")) << "the same on both sides, once";
}

TEST_F(Strip, aChangeOfASideIsAnnounced)
{
    Announcements announcements(strip);
    strip.setVerdict(leftBlocked());
    (void)announcements.consume();
    TwoTrackVerdict other = leftBlocked();
    std::swap(other.side[0], other.side[1]);
    strip.setVerdict(other);
    EXPECT_EQ(announcements.consume(), QStringList{strip.question()});
    strip.setVerdict(other);
    EXPECT_EQ(announcements.consume(), QStringList());
}

TEST_F(Strip, twoSidesAreNotCutInTheNarrowestWindow)
{
    TwoTrackVerdict both = leftBlocked();
    for (Verdict& side : both.side) {
        side.stepVerdict = StepVerdict::CannotTell;
        side.shortfall = Shortfall::Spanned;
    }
    both.side[1].shortfall = Shortfall::NothingFelt;
    both.both = StepVerdict::CannotTell;
    strip.setVerdict(both, "probe left at 0.4 m: 0.87 → 0.53 bit");
    QCoreApplication::processEvents();
    for (const std::string& text : gui::cutText(strip)) ADD_FAILURE() << text;
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
