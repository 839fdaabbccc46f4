// Tests the export of the strip of felt ground from the running console.
#include "app/console/past/strip_export.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>

#include "app/figures/report/strip_file.h"
#include "core/store/file_read.h"
#include "tests/support/benches/console_bench.h"
#include "tests/support/felt_strip.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct StripExportOf : Console {
    TemporaryDirectory directory;
    StripExport& exports() { return *window->findChild<StripExport*>(); }
    QString refusalOf(const std::function<void()>& act)
    {
        QSignalSpy refused(&exports(), &StripExport::refused);
        act();
        gui::eventually([&] { return !exports().isWriting(); });
        return refused.isEmpty()
                 ? QString()
                 : QString::fromStdString(qvariant_cast<Message>(refused.first().at(0)).english());
    }
};

TEST_F(StripExportOf, writesWhatTheCommandWrites)
{
    open(fastRobot(robot, 2.0));
    EXPECT_TRUE(refusalOf([&] { exports().ask(); }).contains("nothing was estimated yet"));
    proposeByKeyboard();
    ASSERT_TRUE(gui::eventually(
        [&] { return !window->exploration().estimation().strip().sections().empty(); }));
    const auto strip = std::make_shared<const Strip>(window->exploration().estimation().strip());
    for (const char* name : {"live.svg", "live.png", "live.pdf", "live.csv", "live.ply"}) {
        EXPECT_EQ(refusalOf([&] { exports().write(QString::fromStdString(directory.file(name))); }),
                  QString())
            << name;
        const std::string other = directory.file(std::string("command-") + name);
        ASSERT_TRUE(writeStrip(other, strip, robot, "Strip of felt ground of a running drive"));
        EXPECT_TRUE(withoutSurfaces(*readFile(directory.file(name), 1U << 26U))
                    == withoutSurfaces(*readFile(other, 1U << 26U)))
            << name;
    }
}

TEST_F(StripExportOf, replacesNoFileAndReportsTrouble)
{
    open(fastRobot(robot, 2.0));
    proposeByKeyboard();
    directory.write("kept.svg", "kept");
    const auto write = [&](const std::string& path) {
        return refusalOf([&] { exports().write(QString::fromStdString(path)); });
    };
    EXPECT_TRUE(write(directory.file("kept.svg")).contains("was not replaced"));
    EXPECT_TRUE(write(directory.file("kept")).contains("kept.svg exists")) << "the ending is added";
    EXPECT_EQ(*readFile(directory.file("kept.svg"), 100), "kept");
    EXPECT_TRUE(write("/nowhere/strip.svg").contains("/nowhere/strip.svg"));
    EXPECT_TRUE(write(directory.file("strip.xyz")).contains("the ending tells the format"));
}

TEST_F(StripExportOf, theViewMenuOffersIt)
{
    open(fastRobot(robot, 2.0));
    QAction* offered = nullptr;
    for (QAction* const action : window->viewButton()->menu()->actions())
        if (action->text().startsWith("Export the strip")) offered = action;
    ASSERT_NE(offered, nullptr);
    EXPECT_TRUE(refusalOf([&] { offered->trigger(); }).contains("no strip to export"));
}

}  // namespace
}  // namespace terratact
