// Tests the replay bar with its buttons and keys.
#include "app/console/past/replay_bar.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <fstream>

#include "app/shell/key_table.h"
#include "drivers/log_replay.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct TheReplayBar : testing::Test {
    void SetUp() override
    {
        std::ofstream log(directory.file("drive.log"));
        for (int i = 0; i <= 300; ++i)
            log << fmt::format("({:.6f}) can0 123#00\n", 1000.0 + 0.1 * i);
        log.close();
        auto opened = LogReplay::open(
            directory.file("drive.log"), {},
            {.now = [this] { return now; }, .sleep = [this](double s) { now += s; }});
        ASSERT_TRUE(opened) << opened.error().text;
        replay = std::move(*opened);
        bar = std::make_unique<ReplayBar>(*replay, nullptr);
        bar->addKeys(keys);
        pass(1.0);
    }
    /// Lets `seconds` of the log pass.
    void pass(double seconds)
    {
        std::array<BusFrame, 64> frames;
        for (const double until = now + seconds; now < until; now += 0.05)
            for (auto count = replay->receive(frames, std::chrono::milliseconds(0));
                 count && *count > 0;)
                count = replay->receive(frames, std::chrono::milliseconds(0));
        bar->poll();
    }
    void press(Qt::Key key)
    {
        const QKeyEvent event(QEvent::KeyPress, key, Qt::ControlModifier);
        const KeyTable::Entry* entry = keys.entryOf(event);
        ASSERT_TRUE(entry) << key;
        entry->pressed();
    }
    double at() const { return replay->progress().at; }
    bool says(const QString& text) const
    {
        const auto labels = bar->findChildren<QLabel*>();
        return std::ranges::any_of(
            labels, [&](const QLabel* label) { return label->text().contains(text); });
    }

    TemporaryDirectory directory;
    double now = 100.0;  ///< [s]
    std::unique_ptr<LogReplay> replay;
    std::unique_ptr<ReplayBar> bar;
    KeyTable keys;
};

TEST_F(TheReplayBar, pausesAndContinues)
{
    for (const bool byKey : {false, true}) {
        const auto toggle = [&] { byKey ? press(Qt::Key_Space) : bar->pauseButton()->click(); };
        toggle();
        pass(0.1);
        const double stood = at();
        pass(1.0);
        EXPECT_EQ(at(), stood);
        EXPECT_TRUE(says("paused"));
        toggle();
        pass(1.0);
        EXPECT_GT(at(), stood + 0.5);
        EXPECT_FALSE(says("paused"));
    }
}

TEST_F(TheReplayBar, goesBackAndOn)
{
    pass(15.0);
    const double length = replay->progress().length;
    ASSERT_NEAR(length, 30.0, 0.01);
    for (const bool byKey : {false, true}) {
        replay->seek(0.5 * length);
        pass(0.1);
        const double middle = at();
        byKey ? press(Qt::Key_Left) : bar->backButton()->click();
        pass(0.1);
        EXPECT_NEAR(at(), std::max(0.0, middle - ReplayBar::kStep), 0.5);
        const double back = at();
        byKey ? press(Qt::Key_Right) : bar->onButton()->click();
        pass(0.1);
        EXPECT_NEAR(at(), std::min(length, back + ReplayBar::kStep), 0.5);
    }
}

TEST_F(TheReplayBar, beginsAgainOnlyWhereItRepeats)
{
    const double length = replay->progress().length;
    pass(length + 5.0);
    EXPECT_EQ(replay->state(), BusState::Ended);
    replay->seek(0.0);
    press(Qt::Key_R);
    pass(length - 1.0);
    EXPECT_GT(at(), 0.5 * length);
    pass(2.0);
    EXPECT_LT(at(), 0.5 * length) << "from its begin";
    EXPECT_TRUE(bar->repeatButton()->isChecked());
    bar->repeatButton()->click();
    pass(length + 5.0);
    EXPECT_EQ(replay->state(), BusState::Ended);
}

}  // namespace
}  // namespace terratact
