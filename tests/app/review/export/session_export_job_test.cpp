// Tests exports that a review runs.
#include "app/review/export/session_export_job.h"

#include <gtest/gtest.h>

#include <QRadioButton>

#include "app/figures/report/strip_file.h"
#include "app/recording/what_if.h"
#include "app/review/export/review_export_dialog.h"
#include "app/review/review_window.h"
#include "tests/support/benches/export_bench.h"
#include "tests/support/felt_strip.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ExportOf, visibleAndWholeExportsEqualTheCommandLines)
{
    record();
    open();
    choose("CAN frames", ".log", "all.log");
    QTest::mouseClick(window->exportDialog()->wholeSession(), Qt::LeftButton);
    write();
    EXPECT_EQ(written("all.log"), commandWrites("command-all.log", {}));

    window->timeline()->showSpan(1.0, 3.0);
    choose("CAN frames", ".asc", "zoomed.asc");
    QTest::mouseClick(window->exportDialog()->visibleSpan(), Qt::LeftButton);
    write();
    EXPECT_EQ(written("zoomed.asc"),
              commandWrites("command-zoomed.asc", {.from = window->timeline()->first(),
                                                   .to = window->timeline()->last()}));

    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    window->goTo(1.5);
    press(Qt::Key_B);
    window->goTo(1.0);
    press(Qt::Key_A);
    const ExportSelection cursors{.what = ExportKind::Frames, .from = 1.0, .to = 1.5};
    choose("CAN frames", ".csv", "cursors.csv");
    EXPECT_TRUE(window->exportDialog()->visibleSpan()->text().contains("A to B"));
    write();
    EXPECT_EQ(written("cursors.csv"), commandWrites("command-cursors.csv", cursors));
    EXPECT_LT(written("cursors.csv").size(), 0.5 * static_cast<double>(written("all.log").size()));
    choose("CAN frames", ".mcap", "cursors.mcap");
    write();
    EXPECT_EQ(written("cursors.mcap"), commandWrites("command-cursors.mcap", cursors));
}

TEST_F(ExportOf, theStripEqualsThatOfTheCommand)
{
    record();
    open();
    auto session = SessionReader::open(path.toStdString());
    const auto robot = robotOf(*session);
    const auto strip = stripOf(*session, *robot);
    for (const std::string name : {"strip.svg", "strip.csv", "strip.ply"}) {
        const std::string other = directory.file("command-" + name);
        const Status done = writeStrip(other, strip, *robot, "Strip of felt ground of review.tts");
        choose("Strip of felt ground", QString::fromStdString(name.substr(5)), name);
        EXPECT_TRUE(done) << done.error().text;
        write();
        EXPECT_TRUE(withoutSurfaces(written(name)) == withoutSurfaces(written("command-" + name)))
            << name;
    }
}

TEST_F(ExportOf, cancelledExportLeavesNoFileAndBlocksNothing)
{
    {
        auto writer = robotSession(path.toStdString(), 60.0, 850.0);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    open();
    const QStringList before = files();
    choose("Frames, signals", ".mcap", "big.mcap");
    ReviewExportDialog& dialog = *window->exportDialog();
    QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
    ASSERT_TRUE(dialog.writes()) << "does not wait";
    EXPECT_TRUE(dialog.progressBar()->isVisible());
    EXPECT_FALSE(dialog.exportButton()->isEnabled());
    window->goTo(12.0);
    EXPECT_EQ(now(), 12.0);
    QTest::keyClick(&dialog, Qt::Key_Escape);
    ASSERT_TRUE(eventually([&] { return !dialog.writes(); }));
    EXPECT_TRUE(dialog.resultLabel()->text().startsWith("Cancelled"))
        << dialog.resultLabel()->text().toStdString();
    EXPECT_EQ(files(), before);
    EXPECT_TRUE(dialog.isVisible());

    QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
    window.reset();  // closes the window during the export
    EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace terratact
