// Tests STOP and its release, the lost link, and driving: everything that halts the robot.
#include <QLabel>
#include <QPushButton>

#include "app/console/connection/link_status.h"
#include "drivers/memory_bus.h"
#include "tests/support/benches/exploration_bench.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"

namespace terratact {
namespace {

TEST_F(Bench, stopReadsSentUntilTheRobotConfirms)
{
    using State = StopViewState::State;
    EXPECT_EQ(exploration->stopViewState().state, State::Ready);
    exploration->stop();
    EXPECT_EQ(exploration->stopViewState().state, State::Sent) << "before any tick";
    tick(10);
    exploration->stop();  // pressing again does not restart the time
    tick(10);
    EXPECT_EQ(exploration->stopViewState().state, State::Sent);
    EXPECT_NEAR(exploration->stopViewState().seconds, 0.8, 1e-6);
    telemetry.activity = RobotActivity::Stopped;
    tick();
    EXPECT_EQ(exploration->stopViewState().state, State::Confirmed);
    tickInSilence(20);
    EXPECT_EQ(exploration->stopViewState().state, State::Confirmed) << "silence takes nothing back";
    telemetry.activity = RobotActivity::Halted;
    tick();
    EXPECT_EQ(exploration->stopViewState().state, State::Sent) << "but telemetry does";
    EXPECT_LT(exploration->stopViewState().seconds, 0.1);
}

TEST_F(Bench, unsentStopIsReportedOnceAndRetried)
{
    using State = StopViewState::State;
    source.setDeaf(true);
    exploration->stop();
    EXPECT_EQ(exploration->stopViewState().state, State::NotSent);
    EXPECT_EQ(exploration->stopViewState().why, "the bus is off");
    tick(20);
    EXPECT_GE(sent<StopCommand>(), 3);
    EXPECT_EQ(exploration->stopViewState().state, State::NotSent);
    EXPECT_NEAR(exploration->stopViewState().seconds, 0.8, 1e-6);
    EXPECT_EQ(events.filter("STOP not sent").size(), 1);
    source.setDeaf(false);
    tick(10);
    EXPECT_EQ(exploration->stopViewState().state, State::Sent);
}

TEST_F(Bench, stopIsRepeatedToARobotWithoutTelemetry)
{
    Exploration another(source, RobotModel{}, *worker, Exploration::Options{});
    another.stop();
    for (int i = 0; i < 20; ++i) another.tick({.now = (now += 0.04)});
    EXPECT_GE(sent<StopCommand>(), 3);
    EXPECT_EQ(another.stopViewState().state, StopViewState::State::Sent);
}

TEST_F(Bench, aRobotThatStoppedItselfIsShownAsStopped)
{
    telemetry.activity = RobotActivity::Stopped;
    tick();
    EXPECT_EQ(phase(), AtemPhase::Stopped);
}

TEST_F(Bench, aLostLinkFailsTheExploration)
{
    press();
    tickInSilence(10);
    EXPECT_EQ(exploration->state().failure, AtemFailure::LinkLost);
    EXPECT_FALSE(exploration->linkAlive());
    EXPECT_TRUE(exploration->whyNotDriving());
    tick();
    EXPECT_TRUE(exploration->linkAlive());
}

TEST_F(Bench, theVerdictIsWithheldAsSoonAsTheTelemetryIsStale)
{
    propose();
    const auto withheld = [this] {
        const std::vector<WithholdReason> doubts =
            exploration->estimation().verdict()->side[0].withheldFor;
        return std::ranges::find(doubts, WithholdReason::Stale) != doubts.end();
    };
    const double heard = now;
    EXPECT_FALSE(withheld());
    exploration->tick({.now = heard + kStaleAfter - 0.001, .latest = latest});
    EXPECT_FALSE(withheld());
    exploration->tick({.now = heard + kStaleAfter + 0.001, .latest = latest});
    EXPECT_TRUE(withheld()) << "with the values";
    EXPECT_TRUE(exploration->linkAlive()) << "the link is lost later";
    now = heard + kStaleAfter + 0.001;
    tick();
    EXPECT_FALSE(withheld());
}

/// A decided verdict with an open proposal, followed by an outage.
struct Outage : Bench {
    Outage()
    {
        withDraws = true;
        propose();
    }
    void linkIsLostFor(double seconds)
    {
        tickInSilence(static_cast<int>(seconds / 0.04 + 0.5)
                      - 1);  // the next line ends the silence
        tick(3);
    }
    std::vector<WithholdReason> doubts() const
    {
        return exploration->estimation().verdict()->side[0].withheldFor;
    }
};

TEST_F(Outage, longerThanASecondWithholdsVerdictUntilNextPress)
{
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    ASSERT_EQ(exploration->estimation().verdict()->both, StepVerdict::Blocked);
    linkIsLostFor(kMaxSilence - 0.04);
    EXPECT_EQ(doubts(), std::vector<WithholdReason>());
    EXPECT_EQ(exploration->estimation().verdict()->both, StepVerdict::Blocked);

    linkIsLostFor(kMaxSilence + 0.04);
    EXPECT_TRUE(exploration->linkAlive());
    ASSERT_TRUE(exploration->estimation().estimate()) << "it stays to be seen";
    EXPECT_EQ(doubts(), std::vector{WithholdReason::TelemetryGap});
    EXPECT_EQ(exploration->estimation().verdict()->both, StepVerdict::CannotTell);
    tick(100);
    EXPECT_EQ(doubts(), std::vector{WithholdReason::TelemetryGap})
        << "however long telemetry comes again";

    telemetry.activity = RobotActivity::Halted;
    propose();
    EXPECT_EQ(doubts(), std::vector<WithholdReason>());
    EXPECT_EQ(exploration->estimation().verdict()->both, StepVerdict::Blocked);
}

TEST_F(Outage, withholdsTheVerdictWithoutAPoll)
{
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    now += kMaxSilence + 0.04;  // the window is frozen meanwhile
    line();
    line();
    tick();
    EXPECT_EQ(doubts(), std::vector{WithholdReason::TelemetryGap});
}

TEST_F(Outage, ofAFrozenWindowIsNoLostLink)
{
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    for (int i = 0; i < 100; ++i) line();
    tick();
    EXPECT_EQ(doubts(), std::vector<WithholdReason>()) << "telemetry has come all the time";
}

TEST_F(Outage, voidsAnOpenProposal)
{
    const quint64 question = exploration->proposal()->id;
    EXPECT_FALSE(firstMissing(exploration->toProbe()));
    now += kMaxSilence + 0.04;  // not polled, otherwise the exploration would have failed
    line();
    tick();
    ASSERT_EQ(phase(), AtemPhase::ProposingProbe);
    EXPECT_TRUE(mentions(firstMissing(exploration->toProbe()), "the link was lost"));
    exploration->approve(question);
    tick();
    EXPECT_EQ(exploration->state().failure, AtemFailure::ApprovalVoid);
    EXPECT_EQ(sent<ProbeCommand>(), 0);
}

/// The displays of an exploration with simulated time.
struct LinkBench : Bench {
    LinkBench() : display(header, banner, list, acquisition, nullptr) {}
    void showAt(double time)
    {
        exploration->tick({.now = time, .latest = latest});
        display.show({.now = time,
                      .newest = &*latest,
                      .link = watch.poll({.now = time,
                                          .age = time - secondsOf(latest->arrived),
                                          .alive = exploration->linkAlive()})});
    }
    LinkWatch watch;
    StatusHeader header;
    QLabel banner;
    EventList list;
    ScriptedSource other;
    Acquisition acquisition{other};
    LinkStatus display;
};

TEST_F(LinkBench, linkWatchdogExpiresAfter250msAndShowsTheBanner)
{
    EXPECT_EQ(exploration->options().linkLostAfter, 0.25);
    const double heard = now;
    for (const double age : {0.0, 0.15, 0.24, 0.2499}) {
        showAt(heard + age);
        EXPECT_TRUE(exploration->linkAlive()) << age;
        EXPECT_TRUE(banner.isHidden()) << age;
        EXPECT_FALSE(header.linkText().startsWith("LINK LOST")) << age;
    }
    showAt(heard + 0.2501);
    EXPECT_FALSE(exploration->linkAlive());
    EXPECT_TRUE(banner.isVisible()) << "with the first picture after that";
    EXPECT_EQ(banner.text(), "LINK LOST for 250 ms — nothing on this screen is live");
    EXPECT_TRUE(header.linkText().startsWith("LINK LOST"));
    showAt(heard + 0.26);
    EXPECT_EQ(banner.text(), "LINK LOST for 260 ms — nothing on this screen is live");
    now = heard + 0.26;
    line();
    showAt(now);
    EXPECT_TRUE(exploration->linkAlive()) << "one line of telemetry is enough";
    EXPECT_EQ(banner.text(),
              "LINK RESTORED after 260 ms — values are live; the terrain predates the gap");
    for (const double back = now; now - back < 0.99;) {
        EXPECT_TRUE(banner.isVisible()) << "for a second: it may go again";
        line();
        showAt(now);
    }
    line();
    showAt(now);
    EXPECT_TRUE(banner.isHidden());
    EXPECT_TRUE(header.linkText().startsWith("link ")) << header.linkText().toStdString();
}

TEST_F(LinkBench, aFlappingLinkIsOneEventAndKeepsTheBanner)
{
    int banners = 0;  // number of times a banner appeared
    const auto pass = [&](double seconds, bool comes) {
        for (const double until = now + seconds; now < until;) {
            const bool was = !banner.isHidden();
            if (comes)
                line();
            else
                now += 0.04;
            showAt(now);
            banners += !was && !banner.isHidden();
        }
    };
    pass(1.5, true);
    for (int i = 0; i < 7; ++i) {
        pass(0.3, false);
        EXPECT_FALSE(exploration->linkAlive()) << "no value is shown";
        pass(0.3, true);
        EXPECT_TRUE(exploration->linkAlive()) << "nor is one withheld that is fresh";
    }
    EXPECT_EQ(banners, 1);
    EXPECT_TRUE(banner.text().startsWith("LINK UNSTEADY — gaps: 7, the longest "))
        << banner.text().toStdString();
    EXPECT_EQ(header.linkText(), "LINK UNSTEADY");
    pass(1.2, true);
    EXPECT_TRUE(banner.isHidden());
    const auto event = [this](int row) { return list.item(row)->text().mid(10); };
    ASSERT_EQ(list.count(), 3);
    EXPECT_EQ(event(2), "link is up");
    EXPECT_EQ(event(1), "✘ link lost");
    EXPECT_TRUE(event(0).startsWith("link is up; gaps before: 7, the longest "));
}

TEST_F(Bench, busErrorsWithholdTheVerdictOnlyWhileRecent)
{
    MemoryBus bus{steadyNow};
    CanSource link(bus.join("can0"), RobotModel{}, {.mode = CanSource::Mode::Listen});
    const Acquisition acquisition(link);
    StatusHeader header;
    QLabel banner;
    EventList list;
    LinkStatus display(header, banner, list, acquisition, &link);
    const auto showAt = [&](double time) {
        now = time - 0.04;
        line();
        const CanView view = link.view();
        display.show({.now = time,
                      .bus = &view,
                      .newest = &*latest,
                      .link = {.standing = LinkStanding::Up, .alive = true}});
    };
    const auto toneOfLink = [&] {
        for (const QLabel* label : header.findChildren<QLabel*>())
            if (label->text() == header.linkText()) return label->property("tone").toString();
        return QString();
    };
    const auto role = [&] { return header.busButton()->property("role").toString(); };
    const double began = now;
    showAt(began);
    const QString calm = role();
    EXPECT_EQ(toneOfLink(), "good");

    bus.dropNext(1);
    bus.put({.id = 0x100, .length = 1, .data = {}});
    bus.put({.id = 4, .error = true, .length = 8, .data = {}});
    ASSERT_TRUE(gui::eventually([&] {
        const BusCounters frames = link.view().frames;
        return frames.dropped == 1 && frames.errorFrames == 1;
    }));
    showAt(began + 1.0);
    EXPECT_TRUE(header.busButton()->text().contains("! 1 dropped ! 1 errors"))
        << header.busButton()->text().toStdString();
    EXPECT_EQ(role(), "caution");
    EXPECT_EQ(toneOfLink(), "warning");
    showAt(began + 1.0 + GrowingCount::kLately);
    EXPECT_TRUE(header.busButton()->text().contains(" 1 dropped 1 errors"))
        << header.busButton()->text().toStdString();
    EXPECT_TRUE(header.linkText().contains("1 dropped")) << "it has been";
    EXPECT_EQ(role(), calm);
    EXPECT_EQ(toneOfLink(), "good");
}

}  // namespace
}  // namespace terratact
