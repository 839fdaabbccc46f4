// Tests the widgets that only show text: readout, strip, events. Also what a screen reader announces.
#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/display/format.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/spoken.h"
#include "widgets/base/theme.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

TEST(Words, aToneEndsAlsoAfterAChangeOfFont)
{
    applyLook(*qApp, ThemeName::Day, 100);
    PlainLabel label;
    label.show();
    setTone(label, Tone::Plain);
    const QColor plain = label.palette().color(QPalette::WindowText);
    setTone(label, Tone::Bad);
    EXPECT_NE(label.palette().color(QPalette::WindowText), plain);
    applyLook(*qApp, ThemeName::Day, 80);
    QCoreApplication::processEvents();
    setTone(label, Tone::Plain);
    EXPECT_EQ(label.palette().color(QPalette::WindowText), plain);
    applyLook(*qApp, ThemeName::Day, 100);
}

TEST(Words, numbersReadAsOperatorsWriteThem)
{
    EXPECT_EQ(format::signedNumber(-0.254, 2), QStringLiteral("−0.25"));
    EXPECT_EQ(format::signedNumber(0.254, 2), "+0.25");
    EXPECT_EQ(format::degrees(0.1), QStringLiteral("+5.7°"));
    EXPECT_EQ(format::countdown(83.2), "1:24");
    EXPECT_EQ(format::countdown(-3.0), "0:00");
    EXPECT_EQ(format::age(0.041), "41 ms");
    EXPECT_EQ(format::age(2.44), "2.4 s");
    for (const double bad : {gui::kHostile[0], gui::kHostile[1]}) {
        EXPECT_EQ(format::signedNumber(bad, 2), "--");
        EXPECT_EQ(format::degrees(bad), QStringLiteral("--°"));
        EXPECT_EQ(format::countdown(bad), "--");
        EXPECT_EQ(format::age(bad), "--");
    }
}

TEST(Readout, showsAnglesInDegreesLeftAndRight)
{
    RobotReadout readout;
    Measurement m;
    m.pitch = -0.1;
    m.frontLeft = 0.5;
    m.frontRight = 0.6;
    readout.setMeasurement(m, 0.04);
    EXPECT_EQ(readout.text(RobotReadout::Pitch), QStringLiteral("−5.7°"));
    EXPECT_EQ(readout.text(RobotReadout::FrontFlippers), QStringLiteral("L +28.6°   R +34.4°"));
}

TEST(Readout, theScenesPitchStandsBesideTheCurrentPitch)
{
    RobotReadout readout;
    Measurement m;
    m.pitch = 0.1;
    readout.setMeasurement(m, 0.04, -0.1);
    EXPECT_EQ(readout.text(RobotReadout::Pitch), QStringLiteral("+5.7°   captured −5.7°"));
    readout.setMeasurement(m, 0.151, -0.1);
    EXPECT_EQ(readout.text(RobotReadout::Pitch),
              QStringLiteral("--   151 ms old   captured −5.7°"));
    readout.setMeasurement(m, 0.04);
    EXPECT_EQ(readout.text(RobotReadout::Pitch), QStringLiteral("+5.7°"));
}

TEST(Readout, theTipOfEveryValueIsTheAgeOfItsOwnMessage)
{
    RobotReadout readout;
    readout.setMeasurement({}, 0.04);
    for (int row = 0; row < RobotReadout::kRows; ++row) EXPECT_EQ(readout.ageText(row), "40 ms");
    readout.setMeasurement({}, 0.3, {0.02, 0.02, 0.3, 0.03, 2.44, 0.03});
    EXPECT_EQ(readout.ageText(RobotReadout::Pitch), "20 ms");
    EXPECT_EQ(readout.ageText(RobotReadout::FrontFlippers), "300 ms");
    EXPECT_EQ(readout.ageText(RobotReadout::FrontCurrents), "2.4 s");
    int tips = 0;
    for (const QLabel* label : readout.findChildren<QLabel*>())
        tips += label->toolTip().endsWith(" old") ? 1 : 0;
    EXPECT_EQ(tips, RobotReadout::kRows);
    readout.clearMeasurement();
    EXPECT_EQ(readout.ageText(RobotReadout::Pitch), "");
    for (const QLabel* label : readout.findChildren<QLabel*>()) EXPECT_EQ(label->toolTip(), "");
}

TEST(Readout, theAgeIsShownBesideStaleValues)
{
    RobotReadout readout;
    const double never = std::numeric_limits<double>::infinity();
    readout.setMeasurement({}, 0.02, {0.02, 0.02, 0.02, 0.02, 0.02, 0.02});
    for (int row = 0; row < RobotReadout::kRows; ++row)
        EXPECT_FALSE(readout.text(row).contains("old")) << row;
    readout.setMeasurement({}, 2.44, {0.02, 0.02, 0.3, 0.03, 2.44, never});
    EXPECT_EQ(readout.text(RobotReadout::Pitch), "--   20 ms old") << "half a line is none";
    EXPECT_EQ(readout.text(RobotReadout::FrontCurrents), "--   2.4 s old") << "that is missing";
    EXPECT_EQ(readout.text(RobotReadout::RearCurrents), "--") << "it never came";
}

TEST(Readout, aMissingCurrentOfOneMotorIsNotShown)
{
    RobotReadout readout;
    Measurement m;
    setCurrents(m, {std::nullopt, 1.7, 0.5, 0.5});
    readout.setMeasurement(m, 0.02);
    EXPECT_EQ(readout.text(RobotReadout::FrontCurrents), "L -- A   R +1.70 A");
    EXPECT_EQ(readout.text(RobotReadout::RearCurrents), "L +0.50 A   R +0.50 A");
}

TEST(Readout, staleValuesAreNotShown)
{
    RobotReadout readout;
    readout.setMeasurement({}, 0.149);
    EXPECT_NE(readout.text(RobotReadout::Pitch), "--");
    readout.setMeasurement({}, 0.151);
    for (int row = 0; row < RobotReadout::kRows; ++row)
        EXPECT_EQ(readout.text(row), "--   151 ms old");
    for (const double bad : gui::kHostile) {
        Measurement m;
        m.pitch = m.roll = m.frontLeft = m.rearRightCurrent = bad;
        readout.setMeasurement(m, bad);
        EXPECT_FALSE(gui::painted(readout).isNull());
    }
}

/// Records what a screen reader announces: name and description of announced widgets.
struct Listener final : QObject {
    Listener() { qApp->installEventFilter(this); }
    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() != kAnnounced) return false;
        const QAccessibleInterface* const says = QAccessible::queryAccessibleInterface(object);
        heard << says->text(QAccessible::Name) + QLatin1Char('|')
                     + says->text(QAccessible::Description);
        return false;
    }
    QStringList consume() { return std::exchange(heard, {}); }
    QStringList heard;
};

TEST(Spoken, aLabelGivesItsNameAndItsText)
{
    applyLook(*qApp);
    RobotReadout readout;
    Measurement m;
    m.pitch = -0.1;
    readout.setMeasurement(m, 0.04);
    QStringList said;
    for (QLabel* label : readout.findChildren<QLabel*>())
        said << QAccessible::queryAccessibleInterface(label)->text(QAccessible::Name);
    EXPECT_TRUE(said.contains(QStringLiteral("pitch: −5.7°"))) << said.join('\n').toStdString();
    QLabel rich(QStringLiteral("<b>bold</b> words"));
    EXPECT_EQ(QAccessible::queryAccessibleInterface(&rich)->text(QAccessible::Name), "bold words");
}

TEST(Spoken, urgentTextIsAnnouncedOnce)
{
    applyLook(*qApp);
    StatusHeader header;
    header.setLink("link 20 Hz", Tone::Good);
    VerdictStrip verdict;
    Listener listener;
    header.setLink("link 19 Hz", Tone::Good);
    EXPECT_EQ(listener.consume(), QStringList());
    header.setLink("LINK LOST · 300 ms", Tone::Bad);
    header.setLink("LINK LOST · 340 ms", Tone::Bad);
    EXPECT_EQ(listener.consume(), QStringList{QStringLiteral("Link: LINK LOST · 300 ms|")})
        << "once, not with every picture";
    header.setLink("link 20 Hz", Tone::Good);
    EXPECT_EQ(listener.consume(), QStringList{QStringLiteral("Link: link 20 Hz|")});

    header.setStop({.state = StopViewState::State::Sent});
    header.setStop({.state = StopViewState::State::Sent, .seconds = 0.3});
    const QStringList stop = listener.consume();
    ASSERT_EQ(stop.size(), 1);
    EXPECT_TRUE(stop[0].startsWith("STOP|") && stop[0].contains("not confirmed"))
        << stop[0].toStdString();

    Verdict blocked;
    blocked.stepVerdict = StepVerdict::Blocked;
    verdict.setVerdict(blocked);
    verdict.setVerdict(blocked);
    EXPECT_EQ(listener.consume(), QStringList{QStringLiteral("Verdict: ✘ BLOCKED|")});

    ProbeCard card;
    ProbeProposal probe{.id = 3,
                        .bin = 9,
                        .height = 0.02,
                        .q10 = -0.05,
                        .q90 = 0.09,
                        .sd = 0.055,
                        .worth = {},
                        .others = {}};
    card.setProposal(probe);
    probe.answer = StepVerdict::Blocked;
    card.setProposal(probe);
    const QStringList question = listener.consume();
    ASSERT_EQ(question.size(), 1);
    EXPECT_TRUE(question[0].startsWith("Arm probe|bin 0.6 m; +0.02 m"))
        << question[0].toStdString();
}

struct Strip : testing::Test {
    Strip() { gui::showActive(strip); }
    EstimateStrip strip;
};

TEST_F(Strip, namesTheLeastCertainBin)
{
    strip.setEstimate(stepEstimate(), 0.62);
    EXPECT_EQ(strip.headline(), QStringLiteral("Uncertain at 0.6 m: ± 0.09 m"));
    TerrainEstimate known = stepEstimate();
    known.sd.fill(0.02);
    strip.setEstimate(known, 0.62);
    EXPECT_TRUE(strip.headline().startsWith(QStringLiteral("Known to ± 0.02 m")));
}

TEST_F(Strip, namesTheBudgetThatEndedSampling)
{
    TerrainEstimate e = stepEstimate();
    e.ending = Ending::Time;
    strip.setEstimate(e, 5.0);
    EXPECT_TRUE(strip.details().endsWith("5.0 s · ended: time limit"))
        << strip.details().toStdString();
    e.ending = Ending::Converged;
    strip.setEstimate(e, 0.1);
    EXPECT_TRUE(strip.details().endsWith("100 ms"));
    const auto tips = strip.findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(
        tips, [](const QLabel* l) { return l->toolTip().endsWith("ended: converged"); }));
}

TEST_F(Strip, saysWhatOfTheWayIsRemembered)
{
    TerrainEstimate e = stepEstimate();
    e.settings.method = Method::Trail;
    strip.resize(1200, 40);
    strip.show();
    strip.setEstimate(e, 0.1, "memory: 0.40 m · earlier presses: 1");
    EXPECT_TRUE(strip.details().startsWith("trail")) << strip.details().toStdString();
    EXPECT_TRUE(strip.details().endsWith("100 ms · memory: 0.40 m · earlier presses: 1"));
    QStringList shorter;
    for (int width = 1200; width > 100; width -= 4) {
        strip.resize(width, 40);
        if (shorter.isEmpty() || shorter.last() != strip.details()) shorter << strip.details();
    }
    EXPECT_EQ(shorter.value(1), "trail · memory: 0.40 m · earlier presses: 1");
    EXPECT_EQ(shorter.value(2), "trail · memory: 0.40 m");
    EXPECT_EQ(shorter.value(3), "trail") << "a number is never cut";
    strip.resize(1200, 40);
    strip.setEstimate(e, 0.1, "no memory: the robot reports no odometry");
    shorter.clear();
    for (int width = 1200; width > 100; width -= 4) {
        strip.resize(width, 40);
        shorter << strip.details();
    }
    EXPECT_FALSE(shorter.filter(QRegularExpression("^trail · no memory: the.*…$")).isEmpty());
    strip.resize(1200, 40);
    EXPECT_TRUE(strip.details().contains("100 ms"));
    strip.setEstimate(e, 0.1);
    EXPECT_TRUE(strip.details().endsWith("100 ms"));
}

TEST_F(Strip, everyWarningIsShown)
{
    TerrainEstimate e = stepEstimate();
    e.warnings = {Message::verbatim("roll 8.1°"), Message::verbatim("contact above the body")};
    strip.setEstimate(e, 0.1);
    EXPECT_TRUE(strip.warningText().contains(QStringLiteral("roll 8.1°")));
    EXPECT_TRUE(strip.warningText().contains("contact above the body"));
    e.warnings.clear();
    e.converged = false;
    strip.setEstimate(e, 0.1);
    EXPECT_TRUE(strip.warningText().contains("converged"));
}

TEST_F(Strip, progressBringsCancel)
{
    int cancelled = 0;
    QObject::connect(&strip, &EstimateStrip::cancelled, [&cancelled] { ++cancelled; });
    EXPECT_FALSE(strip.cancelButton()->isVisible());
    strip.setProgress(0.4);
    ASSERT_TRUE(strip.cancelButton()->isVisible());
    EXPECT_EQ(strip.findChild<QProgressBar*>()->value(), 400);
    QTest::mouseClick(strip.cancelButton(), Qt::LeftButton);
    EXPECT_EQ(cancelled, 1);
    for (const double bad : gui::kHostile) {
        strip.setProgress(bad);
        EXPECT_FALSE(gui::painted(strip).isNull());
    }
    strip.setProgress(std::nullopt);
    EXPECT_FALSE(strip.cancelButton()->isVisible());
}

TEST(Events, theNewestStandsOnTopAndTheListIsBounded)
{
    EventList events;
    for (int i = 0; i < 600; ++i) events.add(QString::number(i), EventSeverity::Note, QTime(12, 0));
    EXPECT_EQ(events.count(), 500);
    EXPECT_TRUE(events.item(0)->text().endsWith("599"));
    events.add("link lost", EventSeverity::Bad, QTime(12, 1));
    EXPECT_EQ(events.item(0)->text(), QStringLiteral("12:01:00  ✘ link lost"));
}

TEST(Number, hasNoMinusBeforeAZero)
{
    EXPECT_EQ(format::number(-0.004, 2), QStringLiteral("0.00"));
    EXPECT_EQ(format::number(-0.0, 0), QStringLiteral("0"));
    EXPECT_EQ(format::number(-0.006, 2), QStringLiteral("−0.01"));
    EXPECT_EQ(format::signedNumber(-0.004, 2), QStringLiteral("+0.00"));
}

}  // namespace
}  // namespace terratact
