#pragma once

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFileInfo>

#include "app/review/export/review_export_dialog.h"
#include "app/review/review_window.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"

/// A review whose session is exported.
namespace terratact {

struct ExportOf : ReviewOf {
    /// Opens the dialog with its key.
    ReviewExportDialog& ask()
    {
        press(Qt::Key_E, Qt::ControlModifier);
        return *window->exportDialog();
    }
    /// Chooses list entries by their text, and sets the file name.
    void choose(const QString& what, const QString& format, const std::string& name)
    {
        ReviewExportDialog& dialog = ask();
        choose(*dialog.what(), what);
        choose(*dialog.format(), format);
        dialog.pathEdit()->setText(QString::fromStdString(directory.file(name)));
    }
    static void choose(QComboBox& box, const QString& text)
    {
        const int index = box.findText(text, Qt::MatchStartsWith);
        ASSERT_GE(index, 0) << text.toStdString();
        box.setCurrentIndex(index);
    }
    void write()
    {
        ReviewExportDialog& dialog = *window->exportDialog();
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        ASSERT_TRUE(gui::eventually([&] { return !dialog.writes(); }));
        EXPECT_TRUE(dialog.resultLabel()->text().startsWith("Written"))
            << dialog.resultLabel()->text().toStdString();
    }
    std::string written(const std::string& name)
    {
        return *readFile(directory.file(name), 1U << 26U);
    }
    /// Returns the output of the command line.
    std::string commandWrites(const std::string& name, const ExportSelection& selection)
    {
        auto session = SessionReader::open(path.toStdString());
        const std::string to = directory.file(name);
        EXPECT_TRUE(writeExport(*session, to, *exportFormatOf(to), selection));
        return *readFile(to, 1U << 26U);
    }
    QStringList files() { return QDir(QFileInfo(path).path()).entryList(QDir::Files); }
};

}  // namespace terratact
