// Tests the export dialog of a review.
#include "app/review/export/review_export_dialog.h"

#include <gtest/gtest.h>

#include <QFileInfo>
#include <algorithm>
#include <vector>

#include "app/review/review_window.h"
#include "core/store/file_write.h"
#include "tests/support/benches/export_bench.h"
#include "tests/support/gui.h"
#include "tests/support/own_documents.h"
#include "tests/support/sessions/robot_session.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ExportOf, defaultNamesDifferAndGoToTheDocuments)
{
    const OwnDocuments documents(directory.file("home"));
    record();
    open();
    QSet<QString> names;
    for (const double at : {At::kScene, At::kMarker}) {
        window->goTo(at);
        ReviewExportDialog& dialog = ask();
        for (int what = 0; what < dialog.what()->count(); ++what) {
            dialog.what()->setCurrentIndex(what);
            const QString name = dialog.pathEdit()->text();
            EXPECT_EQ(QFileInfo(name).absolutePath(), documents.folder());
            static const QRegularExpression kSecond(QStringLiteral("-[0-9]+[.][0-9]s[.]"));
            if (at == At::kScene || name.contains(kSecond)) {
                EXPECT_FALSE(names.contains(name)) << name.toStdString();
            }
            names << name;
        }
        dialog.close();
    }
    EXPECT_GE(names.size(), 8);
}

TEST_F(ExportOf, aSecondExportIsProposedUnderAFreeName)
{
    const OwnDocuments documents(directory.file("home"));
    record();
    open();
    window->goTo(At::kMarker);
    choose(*ask().what(), "Numbers");
    ReviewExportDialog& dialog = *window->exportDialog();
    const QString first = dialog.pathEdit()->text();
    EXPECT_EQ(
        first,
        documents.folder()
            + QStringLiteral("/review-numbers-%1s.csv").arg(QString::number(At::kMarker, 'f', 1)));
    write();
    EXPECT_TRUE(QFileInfo::exists(first));
    EXPECT_EQ(dialog.pathEdit()->text(), first) << "the result is that of this file";
    dialog.close();
    ask();
    EXPECT_EQ(dialog.pathEdit()->text(), QString(first).replace(".csv", "-2.csv"));
    EXPECT_EQ(dialog.exportButton()->text(), "Export") << "nothing is replaced";
}

TEST_F(ExportOf, whatIsShownIsWrittenByTheSameDialog)
{
    record();
    open();
    window->goTo(At::kMarker);
    for (const char* format : {".png", ".svg", ".pdf"}) {
        choose("Picture", format, std::string("picture") + format);
        write();
        EXPECT_GT(written(std::string("picture") + format).size(), 2000U);
        EXPECT_TRUE(window->exportDialog()->resultLabel()->text().startsWith("Written: "));
    }
    choose("Numbers", ".csv", "numbers.csv");
    EXPECT_EQ(window->exportDialog()->resultLabel()->text(), "") << "of another export";
    write();
    EXPECT_EQ(written("numbers.csv").rfind("t_s,measured_s,pitch_rad", 0), 0U);
    choose("Report", ".html", "report");  // the dialog adds the ending
    write();
    EXPECT_NE(written("report.html").find("Scene 1 of review.tts"), std::string::npos);
    window->goTo(0.0);
    choose("Mission report", ".html", "mission.html");
    write();
    EXPECT_NE(written("mission.html").find("Decisions and their numbers"), std::string::npos);
    choose("Report", ".html", "none.html");
    EXPECT_FALSE(window->exportDialog()->exportButton()->isEnabled()) << "there is no estimate";
}

TEST_F(ExportOf, aDisabledButtonShowsTheReason)
{
    {
        auto writer = robotSession(path.toStdString(), 60.0, 850.0);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    open();
    gui::TipsOfButtons tips;
    window->rail()->choose(window->rail()->pageOf(Qt::Key_F6));
    for (const double time : {0.0, At::kMarker}) {
        window->goTo(time);
        tips.poll(*window);
    }
    window->goTo(0.0);
    choose("Report", ".html", "report.html");
    ReviewExportDialog& dialog = *window->exportDialog();
    tips.poll(dialog);
    EXPECT_EQ(dialog.exportButton()->toolTip(), "There is no estimate at this time");
    choose("Frames, signals", ".mcap", "");
    dialog.pathEdit()->clear();
    tips.poll(dialog);
    EXPECT_EQ(dialog.exportButton()->toolTip(), "Name the file first");
    choose("Frames, signals", ".mcap", "big.mcap");
    tips.poll(dialog);
    QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
    ASSERT_TRUE(dialog.writes());
    tips.poll(dialog);
    QTest::keyClick(&dialog, Qt::Key_Escape);
    ASSERT_TRUE(eventually([&] { return !dialog.writes(); }));
    EXPECT_EQ(tips.silent(), std::vector<std::string>());
    for (const char* name : {"Export", "Cancel", "Choose …", "As recorded", "Estimate again (E)"})
        EXPECT_TRUE(tips.compared().contains(name)) << name;
}

TEST_F(ExportOf, replacingAFileNeedsTheReplaceButton)
{
    record();
    open();
    ASSERT_TRUE(writeFileAtomically(directory.file("old.log"), "old"));
    choose("CAN frames", ".log", "old.log");
    ReviewExportDialog& dialog = *window->exportDialog();
    EXPECT_EQ(dialog.exportButton()->text(), "Replace the file");
    dialog.pathEdit()->setText("/nowhere/new.log");
    EXPECT_EQ(dialog.exportButton()->text(), "Export");
    QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
    ASSERT_TRUE(eventually([&] { return !dialog.writes(); }));
    EXPECT_TRUE(dialog.resultLabel()->text().startsWith("NOT WRITTEN: /nowhere/new.log"))
        << dialog.resultLabel()->text().toStdString();
    EXPECT_EQ(written("old.log"), "old");
}

TEST_F(ExportOf, dialogCutsNoTextAndNamesEveryControl)
{
    record();
    for (const int scale : {100, 150, 200}) {
        applyLook(*qApp, ThemeName::Day, scale);
        open();
        ReviewExportDialog& dialog = ask();
        for (int what = 0; what < dialog.what()->count(); ++what) {
            dialog.what()->setCurrentIndex(what);
            QCoreApplication::processEvents();
            EXPECT_EQ(cutText(dialog), std::vector<std::string>{}) << scale << " " << what;
        }
        for (const QWidget* widget : dialog.findChildren<QWidget*>()) {
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            if (!widget->isVisible() || widget->objectName().startsWith("qt_")) continue;
            if (!button && !(widget->focusPolicy() & Qt::TabFocus)) continue;
            EXPECT_FALSE(widget->accessibleName().isEmpty()
                         && (!button || button->text().isEmpty()))
                << widget->metaObject()->className();
            EXPECT_GE(std::min(widget->width(), widget->height()), 32)
                << widget->metaObject()->className();
        }
    }
    applyLook(*qApp);
}

}  // namespace
}  // namespace terratact
