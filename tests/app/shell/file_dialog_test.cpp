// Tests where file dialogs begin.
#include "app/shell/file_dialog.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <fstream>

#include "app/shell/new_file.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using gui::eventually;

TEST(FileDialogs, beginWhereTheLastFileWasChosen)
{
    const TemporaryDirectory directory;
    const QString chosen = QString::fromStdString(directory.file("some.log"));
    QWidget parent;
    const auto ask = [&] {
        askForFile(parent, {.title = "Some file", .start = QDir::homePath()},
                   [](const QString&) {});
        return parent.findChild<QFileDialog*>();
    };
    QFileDialog* const first = ask();
    ASSERT_TRUE(first);
    emit first->fileSelected(chosen);
    first->reject();
    ASSERT_TRUE(eventually([&] { return parent.findChildren<QFileDialog*>().empty(); }));
    QFileDialog* const second = ask();
    ASSERT_TRUE(second);
    EXPECT_EQ(second->directory().absolutePath(), QFileInfo(chosen).absolutePath());
    second->reject();
}

TEST(FileDialogs, proposeAFreeNameWhereTheLastFileWasChosen)
{
    const TemporaryDirectory directory;
    QWidget parent;
    const auto ask = [&] {
        askForFile(parent,
                   {.title = "A picture",
                    .start = "terrain.png",
                    .filter = "Pictures (*.png)",
                    .kind = FileWish::Kind::ToWrite},
                   [](const QString&) {});
        return parent.findChild<QFileDialog*>();
    };
    QFileDialog* const first = ask();
    ASSERT_TRUE(first);
    EXPECT_EQ(first->directory().absolutePath(), documentsFolder());
    EXPECT_EQ(first->selectedFiles(), QStringList(newFile(documentsFolder() + "/terrain.png")));
    const std::string file = directory.file("terrain.png");
    std::ofstream(file) << "a picture";
    emit first->fileSelected(QString::fromStdString(file));
    first->reject();
    ASSERT_TRUE(eventually([&] { return parent.findChildren<QFileDialog*>().empty(); }));
    QFileDialog* const second = ask();
    ASSERT_TRUE(second);
    EXPECT_EQ(second->selectedFiles(),
              QStringList(QString::fromStdString(directory.file("terrain-2.png"))));
    second->reject();
}

}  // namespace
}  // namespace terratact
