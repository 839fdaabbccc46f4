// Tests notes of a reviewer.
#include "app/review/review_note_field.h"

#include <gtest/gtest.h>

#include "app/review/review_window.h"
#include "core/store/file_write.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ReviewOf, aNoteIsKeptBesideTheSessionAndNotInIt)
{
    record();
    open();
    const auto content = [&] { return *readFile(path.toStdString(), 1U << 26U); };
    const std::string before = content();
    window->goTo(1.25);
    press(Qt::Key_M);
    QTest::keyClicks(window->noteEdit(), "a, \"step\"");
    QTest::keyClick(window->noteEdit(), Qt::Key_Return);
    ASSERT_EQ(window->notes().size(), 1U);
    const auto notes = readNotes(path.toStdString());
    ASSERT_TRUE(notes) << notes.error().text;
    ASSERT_EQ(notes->size(), 1U);
    EXPECT_EQ((*notes)[0], (ReviewNote{1.25, "a, \"step\""}));
    EXPECT_EQ(content(), before);
    window->goTo(0.0);
    press(Qt::Key_8);
    EXPECT_NEAR(now(), 1.25, 1e-6);
    ASSERT_TRUE(writeFileAtomically(notesPath(path.toStdString()), "t_s,note\nsoon,x\n"));
    EXPECT_FALSE(readNotes(path.toStdString()));
}

}  // namespace
}  // namespace terratact
