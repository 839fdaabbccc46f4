// Tests the context menu of the terrain's picture.
#include "app/pages/picture_tools.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <optional>

#include "app/pages/terrain_picture.h"
#include "app/shell/key_table.h"
#include "core/store/file_read.h"
#include "tests/support/benches/terrain_bench.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct Pictured : TerrainView {
    Pictured()
    {
        tools.addKeys(keys);
        view.setEstimate(stepEstimate());
    }
    QAction* action(const QString& begin)
    {
        for (QAction* each : tools.menu()->actions())
            if (each->text().startsWith(begin)) return each;
        return nullptr;
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        const QKeyEvent event(QEvent::KeyPress, key, modifiers);
        keys.filter(view, view, event);
    }
    PictureTools tools{view, [] { return 0.1; }};
    KeyTable keys;
};

TEST_F(Pictured, theMenuOpensByClickAndByKeys)
{
    EXPECT_EQ(tools.menu(), nullptr) << "it is made at its first use";
    const QPoint at(40, 40);
    QContextMenuEvent click(QContextMenuEvent::Mouse, at, view.canvas()->mapToGlobal(at));
    QCoreApplication::sendEvent(view.canvas(), &click);
    ASSERT_NE(tools.menu(), nullptr);
    EXPECT_TRUE(tools.menu()->isVisible());
    tools.menu()->close();
    press(Qt::Key_Menu);
    EXPECT_TRUE(tools.menu()->isVisible());
    tools.menu()->close();
    press(Qt::Key_F10, Qt::ShiftModifier);
    EXPECT_TRUE(tools.menu()->isVisible());
    tools.menu()->close();
    press(Qt::Key_F10);
    EXPECT_FALSE(tools.menu()->isVisible()) << "that key alone is another page's";
}

TEST_F(Pictured, copiesPictureAndNumbers)
{
    tools.openMenu({});
    action("Copy the picture")->trigger();
    const QImage copied = QApplication::clipboard()->image();
    EXPECT_EQ(copied.size(), view.size());
    action("Copy the numbers")->trigger();
    const QString numbers = QApplication::clipboard()->text();
    EXPECT_EQ(numbers.count('\n'), kBins + 1) << numbers.toStdString();
    view.setMeasuring(true);
    action("Copy the numbers")->trigger();
    EXPECT_TRUE(QApplication::clipboard()->text().contains("m apart"));
}

TEST_F(Pictured, copiedMeasurementsHaveAnAsciiMinus)
{
    TerrainEstimate e = stepEstimate();
    e.touch.fill(Touch::Felt);
    view.setEstimate(e);
    view.setMeasuring(true);
    QCoreApplication::processEvents();
    ASSERT_TRUE(view.measuredLines().join('\n').contains(QChar(0x2212)));
    tools.copyNumbers();
    const QString numbers = QApplication::clipboard()->text();
    EXPECT_TRUE(numbers.contains("m apart")) << numbers.toStdString();
    EXPECT_FALSE(numbers.contains(QChar(0x2212))) << numbers.toStdString();
}

TEST_F(Pictured, numbersBeginWithTheNoteOfThePicture)
{
    view.setEstimate(stepEstimate(), "shown: estimate of 12:03:11, not the present one");
    tools.copyNumbers();
    const QString numbers = QApplication::clipboard()->text();
    EXPECT_TRUE(numbers.startsWith("shown: estimate of 12:03:11, not the present one\n"));
    EXPECT_EQ(numbers.count('\n'), kBins + 2) << numbers.toStdString();
}

TEST_F(Pictured, exportIsOfferedOnlyWhereItDoesSomething)
{
    tools.openMenu({});
    EXPECT_FALSE(action("Export")->isVisible());
    tools.menu()->close();
    const QSignalSpy wanted(&tools, &PictureTools::exportWanted);
    tools.openMenu({});
    EXPECT_TRUE(action("Export")->isVisible());
}

TEST_F(Pictured, measuresZoomsAndExports)
{
    QSignalSpy wanted(&tools, &PictureTools::exportWanted);
    tools.openMenu({});
    EXPECT_FALSE(action("The whole robot")->isEnabled());
    action("Export")->trigger();
    EXPECT_EQ(wanted.size(), 1);
    action("Measure")->trigger();
    EXPECT_TRUE(view.measures());
    tools.menu()->close();
    press(Qt::Key_I);
    EXPECT_FALSE(view.measures());
    action("Closer")->trigger();
    EXPECT_TRUE(view.isZoomed());
    tools.openMenu({});
    EXPECT_TRUE(action("The whole robot")->isEnabled());
    action("The whole robot")->trigger();
    EXPECT_FALSE(view.isZoomed());
}

TEST_F(Pictured, aHiddenPictureTakesNoKeys)
{
    view.hide();
    press(Qt::Key_I);
    press(Qt::Key_Menu);
    EXPECT_FALSE(view.measures());
    EXPECT_EQ(tools.menu(), nullptr);
}

TEST_F(Pictured, aPictureAsShownKeepsTheTheme)
{
    const TemporaryDirectory directory;
    applyLook(*qApp, ThemeName::NightRed);
    view.restyle();
    const QString file = QString::fromStdString(directory.file("shown.png"));
    EXPECT_TRUE(savePicture(view, file, PictureColours::AsShown).isEmpty());
    const QImage saved(file);
    ASSERT_FALSE(saved.isNull());
    EXPECT_LT(saved.pixelColor(3, 3).lightness(), 60) << "the ground of the night theme";
    EXPECT_EQ(lookInForce().theme, ThemeName::NightRed);
    applyLook(*qApp);
    EXPECT_FALSE(savePicture(view, "picture.bmp", PictureColours::AsShown).isEmpty());
}

TEST_F(Pictured, anExportIsWrittenInAnotherThread)
{
    const TemporaryDirectory directory;
    const QString file = QString::fromStdString(directory.file("terrain.png"));
    std::optional<QString> trouble;
    QWidget parent;
    askAndSavePicture(view, parent, [&](const QString&, const QString& why) { trouble = why; });
    auto* const dialog = parent.findChild<QFileDialog*>();
    ASSERT_TRUE(dialog);
    emit dialog->fileSelected(file);
    EXPECT_FALSE(trouble) << "coding it would hold the window";
    ASSERT_TRUE(gui::eventually([&] { return trouble.has_value(); }));
    EXPECT_EQ(*trouble, "");
    EXPECT_FALSE(QImage(file).isNull());
}

TEST_F(Pictured, anExportReplacesNoFileAndKnowsItsEnding)
{
    const TemporaryDirectory directory;
    const QString folder = QString::fromStdString(directory.file("day.1"));
    ASSERT_TRUE(QDir().mkdir(folder));
    QString written, trouble;
    const auto exportTo = [&](const QString& path) {
        written.clear();
        QWidget parent;
        askAndSavePicture(view, parent, [&](const QString& file, const QString& why) {
            written = file;
            trouble = why;
        });
        auto* const dialog = parent.findChild<QFileDialog*>();
        if (dialog) emit dialog->fileSelected(path);
        EXPECT_TRUE(gui::eventually([&] { return !written.isEmpty(); }));
    };
    exportTo(folder + "/terrain");
    EXPECT_EQ(written, folder + "/terrain.png") << "the folder's point is no ending";
    EXPECT_EQ(trouble, "");
    EXPECT_TRUE(QFileInfo::exists(written));
    const std::string own = directory.write("own.svg", "mine");
    exportTo(QString::fromStdString(own));
    EXPECT_EQ(trouble,
              QString::fromStdString(own) + " exists and was not replaced; choose another name");
    EXPECT_EQ(*readFile(own, 1U << 20U), "mine");
}

}  // namespace
}  // namespace terratact
