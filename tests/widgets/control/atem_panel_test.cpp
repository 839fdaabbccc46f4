#include "widgets/control/atem_panel.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>

#include "tests/support/gui.h"
#include "widgets/base/held_button.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

using Level = Precondition::Level;

struct Atem : testing::Test {
    Atem()
    {
        panel.resize(400, 260);
        gui::showActive(panel);
        QObject::connect(&panel, &AtemPanel::requested, [this] { said << "request"; });
        QObject::connect(&panel, &AtemPanel::aborted, [this] { said << "abort"; });
        QObject::connect(&panel, &AtemPanel::stopReleased, [this] { said << "release"; });
    }
    bool shows(const QString& words) const
    {
        for (const QLabel* label : panel.findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words)) return true;
        return false;
    }
    AtemPanel panel;
    QStringList said;
};

TEST_F(Atem, showsTheStateAndItsTime)
{
    using Kind = PhaseTime::Kind;
    panel.setState({.phase = AtemPhase::Pressing}, PhaseTime{Kind::Expected, 12.2});
    EXPECT_TRUE(shows("Pressing the front flippers"));
    EXPECT_TRUE(shows("about 0:13 left"));
    panel.setState({.phase = AtemPhase::Pressing}, PhaseTime{Kind::GivesUp, 7.0});
    EXPECT_TRUE(shows("gives up in 0:07"));
    EXPECT_FALSE(shows("left"));
    panel.setState({.phase = AtemPhase::ProposingProbe}, PhaseTime{Kind::Answer, 29.1});
    EXPECT_TRUE(shows("0:30 left"));
    EXPECT_FALSE(shows("about"));
    panel.setState({.phase = AtemPhase::Failed, .failure = AtemFailure::LinkLost}, std::nullopt);
    EXPECT_TRUE(shows("link to the robot was lost"));
    EXPECT_FALSE(shows("left"));
    panel.setState({.phase = AtemPhase::Failed, .failure = AtemFailure::ProbeRefused}, std::nullopt,
                   "the robot refused the probe: too far");
    EXPECT_TRUE(shows("Exploration failed: the robot refused the probe: too far"));
    panel.setState({.phase = AtemPhase::Stopped}, std::nullopt, "STOP sent, not confirmed");
    EXPECT_TRUE(shows("STOP sent, not confirmed"));
    EXPECT_FALSE(shows("STOPPED"));
}

TEST_F(Atem, followingPanelHasNoCommandButtons)
{
    panel.setPreconditions({{Level::Missing, Message::verbatim("can0 is receive-only")}});
    panel.setState({.phase = AtemPhase::Probing, .followed = true}, std::nullopt);
    EXPECT_TRUE(shows("Following: flippers pressed, arm is probing"));
    EXPECT_FALSE(panel.requestButton()->isEnabled());
    EXPECT_TRUE(panel.requestButton()->toolTip().contains("receive-only"));
    EXPECT_TRUE(panel.abortButton()->isEnabled());
    EXPECT_TRUE(panel.abortButton()->text().contains("Forget"))
        << "it cannot end the robot's probe";
    panel.setState({.phase = AtemPhase::Stopped, .followed = true}, std::nullopt);
    EXPECT_FALSE(panel.releaseButton()->isVisible()) << "nothing is released from here";
    panel.setState({.phase = AtemPhase::Failed, .failure = AtemFailure::LinkLost, .followed = true},
                   std::nullopt);
    EXPECT_TRUE(shows("Following: no estimate: the link to the robot was lost"));
}

TEST_F(Atem, requestsWhenNothingIsMissing)
{
    panel.setPreconditions({{Level::Met, Message::verbatim("telemetry is live")},
                            {Level::Overridden, Message::verbatim("roll 7°")}});
    QTest::mouseClick(panel.requestButton(), Qt::LeftButton);
    EXPECT_EQ(said, QStringList{"request"});
    EXPECT_TRUE(shows(QStringLiteral("✔")) && shows("!") && shows("roll 7° (overridden)"));
}

TEST_F(Atem, doubtfulPreconditionsNeedAnOverride)
{
    panel.setPreconditions({{Level::Met, Message::verbatim("telemetry is live")}});
    EXPECT_FALSE(panel.overrideButton()->isVisible()) << "there is nothing to override";
    panel.setPreconditions({{Level::Met, Message::verbatim("telemetry is live")},
                            {Level::Doubtful, Message::verbatim("roll 7°")}});
    EXPECT_FALSE(panel.requestButton()->isEnabled());
    EXPECT_TRUE(panel.requestButton()->toolTip().contains("roll 7°"));
    QSignalSpy wanted(&panel, &AtemPanel::overrideWanted);
    QTest::mouseClick(panel.overrideButton(), Qt::LeftButton);
    EXPECT_EQ(wanted.size(), 1);
    panel.setPreconditions({{Level::Missing, Message::verbatim("no telemetry")},
                            {Level::Doubtful, Message::verbatim("roll 7°")}});
    EXPECT_FALSE(panel.overrideButton()->isVisible()) << "what is missing cannot be overridden";
}

TEST_F(Atem, refusesWithTheReasonWhileSomethingIsMissing)
{
    panel.setPreconditions({{Level::Met, Message::verbatim("telemetry is live")},
                            {Level::Missing, Message::verbatim("the model is being loaded")}});
    QTest::mouseClick(panel.requestButton(), Qt::LeftButton);
    EXPECT_TRUE(said.isEmpty());
    EXPECT_TRUE(panel.requestButton()->toolTip().contains("the model is being loaded"));
    EXPECT_TRUE(shows(QStringLiteral("✘")));
    panel.setPreconditions({{Level::Met, Message::verbatim("telemetry is live")}});
    EXPECT_TRUE(panel.requestButton()->isEnabled());
    EXPECT_FALSE(shows("the model is being loaded"));
}

TEST_F(Atem, aNarrowPanelListsWhatIsNotMet)
{
    panel.setPreconditions({{Level::Met, Message::verbatim("telemetry is live")},
                            {Level::Missing, Message::verbatim("not armed")}});
    EXPECT_TRUE(shows("telemetry is live"));
    panel.setNarrow(true);
    EXPECT_TRUE(shows("not armed") && !shows("telemetry is live"));
    panel.lookUp(Commanded::Explore);
    EXPECT_TRUE(shows("telemetry is live"));
    panel.lookUp({});
    panel.setNarrow(false);
    EXPECT_TRUE(shows("telemetry is live"));
}

TEST_F(Atem, isReadyOnlyIfEveryPreconditionIsMet)
{
    panel.setState({}, std::nullopt);
    panel.setPreconditions({{Level::Met, Message::verbatim("telemetry is live")},
                            {Level::Overridden, Message::verbatim("roll 7°")}});
    EXPECT_TRUE(shows("Ready"));
    panel.setPreconditions({{Level::Missing, Message::verbatim("not armed")},
                            {Level::Doubtful, Message::verbatim("roll 7°")}});
    EXPECT_TRUE(shows("Not ready") && !shows("Ready"));
    panel.setState({}, std::nullopt);
    EXPECT_TRUE(shows("Not ready"));
    panel.setPreconditions({{Level::Doubtful, Message::verbatim("roll 7°")}});
    EXPECT_TRUE(shows("Not ready: doubtful"));
    panel.setState({.phase = AtemPhase::Presenting}, std::nullopt);
    EXPECT_TRUE(shows("Estimate stands"));
    panel.forbidCommands();
    panel.setState({}, std::nullopt);
    EXPECT_TRUE(shows("Nothing is explored"));
}

TEST_F(Atem, anExplorationCanBeAbortedButNotRequestedAgain)
{
    panel.setPreconditions({{Level::Met, Message::verbatim("telemetry is live")}});
    panel.setState({.phase = AtemPhase::Probing}, PhaseTime{PhaseTime::Kind::Expected, 80.0});
    EXPECT_FALSE(panel.requestButton()->isEnabled());
    EXPECT_FALSE(panel.requestButton()->toolTip().isEmpty());
    QTest::mouseClick(panel.abortButton(), Qt::LeftButton);
    EXPECT_EQ(said, QStringList{"abort"});
}

TEST_F(Atem, preconditionsOfEveryCommandCanBeLookedUp)
{
    panel.setPreconditions({{Level::Met, Message::verbatim("the model is ready")}});
    panel.setNeeds(Commanded::Drive, {{Level::Met, Message::verbatim("telemetry is live")},
                                      {Level::Missing, Message::verbatim("not armed")}});
    panel.setNeeds(Commanded::Probe, {{Level::Missing, Message::verbatim("no probe is proposed")}});
    panel.setNeeds(Commanded::ReleaseStop, {{Level::Doubtful, Message::verbatim("not confirmed")}});
    EXPECT_TRUE(shows("the model is ready"));
    EXPECT_FALSE(shows("needs:")) << "nobody has asked";

    panel.lookUpNext();
    EXPECT_TRUE(shows("Driving needs:") && shows("telemetry is live") && shows("not armed"));
    EXPECT_FALSE(shows("the model is ready"));
    panel.lookUpNext();
    EXPECT_TRUE(shows("Approving a probe needs:")) << "nothing is to be armed here";
    panel.lookUpNext();
    EXPECT_TRUE(shows("Releasing STOP needs:") && shows("not confirmed"));
    panel.lookUpNext();
    EXPECT_TRUE(shows("the model is ready") && !shows("needs:"));

    QMenu* menu = panel.needsButton()->menu();
    emit menu->aboutToShow();
    QStringList lines;
    for (const QAction* action : menu->actions()) lines << action->text();
    EXPECT_EQ(lines,
              QStringList({"✔ exploring", "✘ driving", "✘ approving a probe", "! releasing STOP"}));
    menu->actions()[1]->trigger();
    EXPECT_EQ(panel.listed(), Commanded::Drive);
    EXPECT_TRUE(panel.requestButton()->isEnabled()) << "the buttons go by their own needs";
    panel.setNeeds(Commanded::Drive, {{Level::Met, Message::verbatim("the robot is armed")}});
    EXPECT_TRUE(shows("the robot is armed")) << "the list is live";
    panel.setState({.phase = AtemPhase::Halting}, std::nullopt);
    EXPECT_EQ(panel.listed(), Commanded::Explore) << "what comes next is not hidden for long";
}

TEST_F(Atem, listsWhatTheNextCommandNeeds)
{
    panel.setPreconditions({{Level::Met, Message::verbatim("the model is ready")}});
    panel.setNeeds(Commanded::Probe, {{Level::Met, Message::verbatim("telemetry is live")},
                                      {Level::Missing, Message::verbatim("not armed")}});
    panel.setNeeds(Commanded::ReleaseStop,
                   {{Level::Met, Message::verbatim("the robot reports stopped")}});
    panel.setState({.phase = AtemPhase::ProposingProbe}, std::nullopt);
    EXPECT_TRUE(shows("Approving a probe needs:") && shows("not armed"));
    EXPECT_FALSE(shows("telemetry is live")) << "the room is the question's";
    panel.lookUp(Commanded::Probe);
    EXPECT_TRUE(shows("telemetry is live"));
    panel.setState({.phase = AtemPhase::Stopped}, std::nullopt);
    EXPECT_TRUE(shows("Releasing STOP needs:") && shows("reports stopped"));
    panel.setNarrow(true);
    panel.setFixedWidth(300);
    EXPECT_TRUE(gui::eventually([&] { return gui::cutText(panel).empty(); }));
    panel.forbidCommands();
    EXPECT_FALSE(panel.needsButton()->isVisible());
}

TEST_F(Atem, releasingStopTakesAHold)
{
    panel.releaseButton()->setHoldTime(100);
    panel.setState({.phase = AtemPhase::Stopped}, std::nullopt);
    EXPECT_TRUE(shows("STOPPED"));
    EXPECT_FALSE(panel.requestButton()->isVisible());
    QTest::mouseClick(panel.releaseButton(), Qt::LeftButton);
    EXPECT_TRUE(said.isEmpty());
    QTest::mousePress(panel.releaseButton(), Qt::LeftButton);
    EXPECT_TRUE(gui::eventually([this] { return said == QStringList{"release"}; }));
}

TEST_F(Atem, aProbeThatIsImpossibleNowIsDisabledAndSaysWhy)
{
    const ProbeToAsk probe{.place = ProbePlace{9}, .text = "0.93 → 0.20 bit"};
    const QPushButton& button = *panel.probeButton();
    const Precondition met{Level::Met, Message::verbatim("telemetry is live")};
    panel.setPreconditions({met});
    panel.setState({.phase = AtemPhase::Presenting}, std::nullopt);
    EXPECT_FALSE(button.isVisible()) << "nothing is offered";
    const auto offers = [&](const QString& reason) {
        return button.isVisible() && !button.isEnabled() && tipOf(button).contains(reason)
            && tipOf(button).contains("0.93 → 0.20 bit");
    };
    panel.setProbeToAsk(probe);
    EXPECT_TRUE(button.isVisible() && button.isEnabled());
    EXPECT_TRUE(button.text().contains("Probe 0.6 m")) << button.text().toStdString();
    panel.setPreconditions({met, {Level::Doubtful, Message::verbatim("roll 7°")}});
    EXPECT_TRUE(offers("override it first")) << tipOf(button).toStdString();
    EXPECT_TRUE(offers("roll 7°") && panel.overrideButton()->isVisible());
    panel.setPreconditions({met, {Level::Missing, Message::verbatim("not armed")}});
    EXPECT_TRUE(offers("not armed")) << tipOf(button).toStdString();
    panel.setPreconditions({met, {Level::Missing, Message::verbatim("STOP is latched")}});
    panel.setState({.phase = AtemPhase::Stopped}, std::nullopt);
    EXPECT_TRUE(offers("STOP is latched") && panel.releaseButton()->isVisible());
    panel.setState({.phase = AtemPhase::Presenting, .followed = true}, std::nullopt);
    EXPECT_TRUE(offers("Not possible now")) << tipOf(button).toStdString();
    panel.setState({.phase = AtemPhase::ProposingProbe}, std::nullopt);
    EXPECT_FALSE(button.isVisible()) << "the probe card has the proposal";
}

TEST_F(Atem, noPlaceToProbeIsSaidOnADisabledButton)
{
    QSignalSpy wanted(&panel, &AtemPanel::probeWanted);
    panel.setPreconditions({{Level::Met, Message::verbatim("telemetry is live")}});
    panel.setState({.phase = AtemPhase::Presenting}, std::nullopt);
    panel.setProbeToAsk(ProbeToAsk{.place = {}, .text = "no bin in reach is left"});
    EXPECT_TRUE(panel.probeButton()->isVisible() && !panel.probeButton()->isEnabled());
    EXPECT_EQ(tipOf(*panel.probeButton()), "no bin in reach is left");
    panel.setProbeToAsk(ProbeToAsk{.place = ProbePlace{9}, .text = {}});
    QTest::mouseClick(panel.probeButton(), Qt::LeftButton);
    ASSERT_EQ(wanted.size(), 1);
    panel.setProbeToAsk(std::nullopt);
    EXPECT_FALSE(panel.probeButton()->isVisible());
    EXPECT_TRUE(panel.abortButton()->isVisible());
}

TEST_F(Atem, forgettingIsPossibleBesideADisabledProbe)
{
    QSignalSpy wanted(&panel, &AtemPanel::forgetWanted);
    const auto forgets = [&] {
        if (!panel.abortButton()->isVisible() || panel.probeButton()->isEnabled()) return false;
        wanted.clear();
        QTest::mouseClick(panel.abortButton(), Qt::LeftButton);
        return wanted.size() == 1;
    };
    const Precondition doubtful{Level::Doubtful, Message::verbatim("roll 7°")};
    panel.setState({.phase = AtemPhase::Presenting}, std::nullopt);
    panel.setProbeToAsk(ProbeToAsk{.place = ProbePlace{9}, .text = {}});
    EXPECT_TRUE(panel.probeButton()->isEnabled());
    EXPECT_FALSE(panel.abortButton()->isVisible()) << "the probe has its place";
    panel.setPreconditions({doubtful});
    EXPECT_TRUE(forgets() && panel.overrideButton()->isVisible());
    panel.setNarrow(true);
    EXPECT_TRUE(forgets() && !panel.requestButton()->isVisible());
    panel.setNarrow(false);
    panel.setPreconditions({{Level::Missing, Message::verbatim("not armed")}});
    EXPECT_TRUE(forgets());
    panel.setState({.phase = AtemPhase::Presenting, .followed = true}, std::nullopt);
    EXPECT_TRUE(forgets()) << "it only follows";
    panel.setState({.phase = AtemPhase::Presenting}, std::nullopt);
    panel.setPreconditions({});
    panel.setProbeToAsk(ProbeToAsk{.place = {}, .text = "the arm measures no height"});
    EXPECT_TRUE(forgets());
}

TEST_F(Atem, aDisabledProbePassesNoFocusToACommand)
{
    panel.setState({.phase = AtemPhase::Presenting}, std::nullopt);
    panel.setProbeToAsk(ProbeToAsk{.place = ProbePlace{9}, .text = {}});
    panel.probeButton()->setFocus();
    ASSERT_EQ(panel.focusWidget(), panel.probeButton());
    panel.setPreconditions({{Level::Doubtful, Message::verbatim("roll 7°")}});
    EXPECT_TRUE(panel.overrideButton()->isVisible());
    EXPECT_NE(panel.focusWidget(), panel.overrideButton()) << "Space would override";
    panel.setPreconditions({});
    panel.probeButton()->setFocus();
    ASSERT_EQ(panel.focusWidget(), panel.probeButton());
    panel.setState({.phase = AtemPhase::Stopped}, std::nullopt);
    EXPECT_TRUE(panel.releaseButton()->isVisible());
    EXPECT_NE(panel.focusWidget(), panel.releaseButton()) << "Space would release STOP";
}

TEST_F(Atem, noButtonIsCutBesideADisabledProbe)
{
    panel.setProbeToAsk(ProbeToAsk{.place = ProbePlace{9}, .text = {}});
    panel.setNarrow(true);
    panel.setFixedWidth(281);
    for (const AtemPhase phase : {AtemPhase::Presenting, AtemPhase::Stopped}) {
        for (const Commanded command : {Commanded::Explore, Commanded::ReleaseStop})
            panel.setNeeds(command, {{Level::Doubtful, Message::verbatim("roll 7°")}});
        panel.setState({.phase = phase}, std::nullopt);
        EXPECT_TRUE(panel.probeButton()->isVisible());
        EXPECT_TRUE(gui::eventually([&] { return gui::cutText(panel).empty(); }))
            << static_cast<int>(phase);
        EXPECT_TRUE(gui::eventually([&] { return gui::scrolledText(panel).empty(); }))
            << static_cast<int>(phase);
        EXPECT_TRUE(shows("roll 7°")) << "its lines remain";
    }
}

TEST_F(Atem, hostileTimesLeaveItDrawn)
{
    for (const double bad : gui::kHostile) {
        panel.setState({.phase = AtemPhase::Pressing, .since = bad},
                       PhaseTime{PhaseTime::Kind::GivesUp, bad});
        EXPECT_FALSE(gui::painted(panel).isNull());
    }
}

}  // namespace
}  // namespace terratact
