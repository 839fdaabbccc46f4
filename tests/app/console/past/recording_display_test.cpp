// Tests how the console shows whether it records.
#include "app/console/past/recording_display.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>

#include "widgets/base/tips.h"

namespace terratact {
namespace {

struct DisplayOfRecording : testing::Test {
    QPushButton button;
    QLabel strip;
    RecordingDisplay display{button, strip};
};

TEST_F(DisplayOfRecording, showsRecordedAndDroppedFrames)
{
    display.show({.recording = true,
                  .path = "/sessions/a.tts",
                  .trouble = {},
                  .frames = 1200,
                  .missing = 7,
                  .bytes = 2'500'000});
    EXPECT_TRUE(button.text().contains("REC")) << button.text().toStdString();
    EXPECT_TRUE(strip.isHidden());
    const QString tip = tipOf(button);
    EXPECT_TRUE(tip.contains("/sessions/a.tts\n1200 frames, 2.5 MB; 7 frames dropped"))
        << tip.toStdString();
}

TEST_F(DisplayOfRecording, aFailureIsAnAlarmWithItsReason)
{
    RecordingState state;
    state.trouble = Message::verbatim("/sessions: no room");
    display.show(state);
    EXPECT_FALSE(strip.isHidden());
    EXPECT_EQ(strip.text(), "NOT RECORDED: /sessions: no room");
    EXPECT_EQ(button.property("role"), "alarm");
    EXPECT_EQ(button.accessibleName(), "Not recorded");
    state = {};
    state.recording = true;
    display.show(state);
    EXPECT_TRUE(strip.isHidden());
    EXPECT_EQ(button.property("role"), "quiet");
}

TEST_F(DisplayOfRecording, aRecordingThatIsOffIsNoAlarm)
{
    RecordingState state;
    state.on = false;
    state.trouble = Message::verbatim("/sessions: no room");
    display.show(state);
    EXPECT_TRUE(strip.isHidden());
    EXPECT_EQ(button.property("role"), "quiet");
    EXPECT_TRUE(button.text().contains("not\nrecorded")) << button.text().toStdString();
}

}  // namespace
}  // namespace terratact
