// Tests where file dialogs begin.
#include "app/shell/file_dialog.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

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

}  // namespace
}  // namespace terratact
