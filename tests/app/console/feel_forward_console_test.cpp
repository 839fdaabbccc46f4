// Tests feel forward in the console: key, button and focus, a robot behind the command gate, and the review of it.
#include <gtest/gtest.h>

#include <QKeyEvent>
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/console/main_window.h"
#include "app/review/review_window.h"
#include "app/shell/key_table.h"
#include "core/log/event_text.h"
#include "core/log/session_reader.h"
#include "tests/support/benches/bus_console_bench.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/held_button.h"
#include "widgets/control/drive_pad.h"
#include "widgets/signals/event_list.h"

namespace terratact {
namespace {

using gui::eventually;

/// A console that feels forward by its key.
struct FeelForwardConsole : BusConsole {
    const AtemState& state() const { return window->exploration().state(); }
    double way() const { return window->exploration().pace().way; }
    HeldButton* button() const { return window->drivePad()->feelButton(); }
    /// Arms, holds the key, and waits until the robot has advanced so far [m].
    bool feelsFor(double metres)
    {
        QTest::keyRelease(window.get(), Qt::Key_F);
        QTest::qWait(2 * KeyTable::kRepetition);  // the next press is a new one
        if (!arms(*window)) return false;
        if (!eventually([&] { return button()->isEnabled(); }, 5000)) return false;
        QTest::keyPress(window.get(), Qt::Key_F);
        if (!eventually([&] { return state().loops; }, 2000)) return false;
        (void)eventually([&] { return !state().loops || way() > metres; }, 60000);
        return state().loops && way() > metres;
    }
    void sendKey(QEvent::Type type, bool repeats)
    {
        QKeyEvent event(type, Qt::Key_F, Qt::NoModifier, "f", repeats);
        QApplication::sendEvent(window.get(), &event);
    }
};

TEST_F(FeelForwardConsole, goesOnThroughTheGateWhileItsKeyIsHeld)
{
    openClear();
    ASSERT_TRUE(feelsFor(0.25));
    EXPECT_TRUE(says("m/min")) << "pace and way are shown";
    picture("feel-forward");
    // A held key repeats: as auto-repeat events, or as a release and a press.
    for (const bool repeats : {true, false}) {
        sendKey(QEvent::KeyRelease, repeats);
        sendKey(QEvent::KeyPress, repeats);
    }
    EXPECT_TRUE(button()->isHeld());
    QTest::keyRelease(window.get(), Qt::Key_F);
    EXPECT_TRUE(eventually([&] { return !state().loops; }, 1000));
    EXPECT_TRUE(eventually(
        [&] { return robotDoes(RobotActivity::Halted) || robotDoes(RobotActivity::Pressed); }));
    const double halted = way();
    QTest::qWait(500);  // waits for an event that must not come
    EXPECT_EQ(way(), halted);
    EXPECT_FALSE(state().loops);
}

TEST_F(FeelForwardConsole, aLoopThatEndedNeedsANewPress)
{
    openClear();
    ASSERT_TRUE(feelsFor(0.0));
    button()->letGo();  // as where it is disabled, while the key stays held
    ASSERT_TRUE(eventually([&] { return !state().loops && button()->isEnabled(); }, 5000));
    const int events = window->events()->count();
    for (int k = 0; k < 5; ++k) {
        sendKey(QEvent::KeyRelease, false);
        sendKey(QEvent::KeyPress, false);
    }
    EXPECT_FALSE(button()->isHeld());
    QTest::qWait(200);  // waits for an event that must not come
    EXPECT_FALSE(state().loops);
    EXPECT_EQ(window->events()->count(), events);
}

TEST_F(FeelForwardConsole, endsWhenTheWindowLosesTheFocusOrThePageIsLeft)
{
    openClear();
    QWidget other;
    const auto endsBy = [&](const std::function<void()>& leave) {
        if (!feelsFor(0.0)) return false;
        leave();
        return eventually([&] { return !state().loops; }, 1000);
    };
    EXPECT_TRUE(endsBy([&] { gui::showActive(other); }));
    EXPECT_EQ(state().loopEnd, LoopEnd::LetGo);
    other.close();
    gui::showActive(*window);
    EXPECT_TRUE(endsBy([&] { QTest::keyClick(window.get(), Qt::Key_F3); }));
    EXPECT_EQ(state().loopEnd, LoopEnd::LetGo);
}

TEST_F(FeelForwardConsole, theButtonMustBeHeld)
{
    openClear();
    ASSERT_TRUE(arms(*window));
    ASSERT_TRUE(eventually([&] { return button()->isEnabled(); }, 5000));
    QTest::mousePress(button(), Qt::LeftButton);
    ASSERT_TRUE(eventually([&] { return state().phase == AtemPhase::Advancing; }, 20000));
    QTest::mouseRelease(button(), Qt::LeftButton);
    EXPECT_TRUE(eventually([&] { return !state().loops; }, 1000));
    EXPECT_EQ(state().loopEnd, LoopEnd::LetGo);
}

TEST_F(FeelForwardConsole, theReviewShowsTheLoop)
{
    const TemporaryDirectory folder;
    recording = std::make_shared<SessionRecorder>(SessionRecorder::Options{
        .folder = folder.file("sessions"), .start = someStart(), .patience = kBusyDisk});
    openClear();
    ASSERT_TRUE(feelsFor(0.15));
    QTest::keyRelease(window.get(), Qt::Key_F);
    ASSERT_TRUE(eventually([&] { return !state().loops; }));
    QTest::qWait(300);
    window.reset();
    recording.reset();

    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.file("sessions")))
        if (entry.path().extension() == ".tts") files.push_back(entry.path().string());
    ASSERT_EQ(files.size(), 1U);
    auto session = SessionReader::open(files.front());
    ASSERT_TRUE(session) << session.error().text;
    int advances = 0;
    std::optional<SessionTime> advancing;
    std::vector<std::string> decisions;
    std::string words;
    for (const EventRow& event : session->events()) {
        if (phaseOf(event) == AtemPhase::Advancing) {
            ++advances;
            advancing = event.time;
        }
        if (event.kind == EventKind::Decision) decisions.push_back(event.subject);
        if (event.kind == EventKind::Word) words += event.text + "\n";
    }
    EXPECT_GE(advances, 2);
    EXPECT_NE(std::ranges::find(decisions, "feel forward"), decisions.end());
    EXPECT_NE(std::ranges::find(decisions, "let go"), decisions.end());
    EXPECT_NE(words.find("advancing 0.1 m: CLEAR for 0.30 m ahead"), std::string::npos) << words;
    EXPECT_NE(words.find("m/min: the control was let go"), std::string::npos) << words;

    ASSERT_TRUE(advancing);
    ReviewWindow review({.session = std::move(*session), .robot = model, .models = {}});
    gui::showActive(review);
    review.goTo(secondsOf(*advancing) + 0.01);
    const auto shows = [&](const QString& text) {
        const auto labels = review.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(text, Qt::CaseInsensitive);
        });
    };
    EXPECT_TRUE(eventually([&] { return shows("advancing"); }));
}

}  // namespace
}  // namespace terratact
