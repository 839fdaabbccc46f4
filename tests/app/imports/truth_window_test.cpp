// Tests the window of decisions on heights from laser maps.
#include "app/imports/truth_window.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QtTest>
#include <cmath>
#include <filesystem>
#include <set>

#include "app/imports/truth_page.h"
#include "app/imports/truth_rows.h"
#include "app/modelling/scene_error.h"
#include "app/shell/open_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sqlite.h"
#include "tests/support/gui.h"
#include "tests/support/made_truth.h"
#include "tests/support/own_documents.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

using namespace gui;

/// A truth file of four scenes, and the window that shows it.
struct TruthBench : testing::Test {
    TruthBench()
    {
        applyLook(*qApp);
        file = directory.file("drive.truth");
        const LaserTruth truth = madeTruth(directory, 4);
        if (!writeTruthFile(file, truth, kRobot)) throw std::runtime_error("no truth file");
    }

    void open()
    {
        auto opened = TruthFile::open(file);
        if (!opened) throw std::runtime_error(opened.error().text);
        window = std::make_unique<TruthWindow>(*std::move(opened));
        window->resize(ConsoleWindow::kMin);
        showActive(*window);
        page = window->page();
    }
    void press(int key, Qt::KeyboardModifiers with = {})
    {
        QTest::keyClick(page->table(), static_cast<Qt::Key>(key), with);
    }
    QString cell(int row, int column) const
    {
        return page->table()->model()->index(row, column).data().toString();
    }
    std::vector<TruthDecision> saved() const
    {
        auto read = readTruthDecisions(page->decisionsPath().toStdString());
        return read ? *read : std::vector<TruthDecision>{};
    }

    static constexpr const char* kRobot = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";
    TemporaryDirectory directory;
    std::string file;
    std::unique_ptr<TruthWindow> window;
    TruthPage* page = nullptr;
};

TEST_F(TruthBench, sceneShowsCloudRobotAndBins)
{
    open();
    const TruthView::Scene& scene = page->view()->scene();
    EXPECT_FALSE(scene.outline.empty());
    EXPECT_GT(scene.slice.size(), 100U);
    EXPECT_TRUE(scene.side[0][3].height);
    EXPECT_TRUE(scene.gap.isEmpty());
    EXPECT_TRUE(page->sceneLabel()->text().contains("Scene 1 of 4"));
    EXPECT_TRUE(page->view()->accessibleDescription().contains("22 bins known"))
        << page->sceneLabel()->text().toStdString();
}

TEST_F(TruthBench, keysDecideAndShowTheNextScene)
{
    open();
    press(Qt::Key_X);
    EXPECT_EQ(page->scene(), 1U);
    press(Qt::Key_A);
    EXPECT_EQ(page->scene(), 2U);
    EXPECT_EQ(cell(0, TruthRows::Decision), "excluded");
    EXPECT_EQ(cell(1, TruthRows::Decision), "accepted");
    EXPECT_EQ(cell(2, TruthRows::Decision), "open");
    press(Qt::Key_Comma);
    press(Qt::Key_Comma);
    EXPECT_TRUE(page->view()->scene().isExcluded);
}

TEST_F(TruthBench, nudgeMovesBinsAndSlice)
{
    open();
    const double height = *page->view()->scene().side[0][10].height;
    const SlicePoint point = page->view()->scene().slice.front();
    press(Qt::Key_U);
    press(Qt::Key_U);
    EXPECT_NEAR(*page->view()->scene().side[0][10].height, height + 0.01, 1e-9);
    press(Qt::Key_F);
    EXPECT_NEAR(*page->view()->scene().side[0][10].height,
                height + 0.01 + std::tan(0.005) * binCentre(10), 1e-9);
    EXPECT_NEAR(page->view()->scene().slice.front().z, point.z + 0.01 + std::tan(0.005) * point.x,
                1e-9);
    EXPECT_EQ(cell(0, TruthRows::Nudge), "+10 mm, +0.3°");
    EXPECT_EQ(page->scene(), 0U) << "a nudge stays at its scene";
    press(Qt::Key_0);
    EXPECT_NEAR(*page->view()->scene().side[0][10].height, height, 1e-9);
    for (int i = 0; i < 50; ++i) press(Qt::Key_D);
    EXPECT_EQ(page->scene(), 0U);
    EXPECT_EQ(cell(0, TruthRows::Nudge), "−200 mm");
    EXPECT_NEAR(*page->view()->scene().side[0][10].height, height - kMaxNudge, 1e-9);
}

TEST_F(TruthBench, nudgeAlongSamplesBinsAndSliceAgain)
{
    open();
    const auto stepAt = [this] {
        double x = 9.0;
        for (const SlicePoint& p : page->view()->scene().slice)
            if (p.line == TruthLine::LeftFlippers && p.z > -0.15) x = std::min(x, p.x);
        return x;
    };
    const double step = stepAt();
    const SideTruth before = page->view()->scene().side[0];
    for (int i = 0; i < 5; ++i) press(Qt::Key_J);
    EXPECT_NEAR(stepAt(), step - 0.1, 0.005);
    EXPECT_EQ(cell(0, TruthRows::Nudge), "−100 mm along");
    EXPECT_EQ(page->scene(), 0U) << "a nudge stays at its scene";
    const SideTruth moved = page->view()->scene().side[0];
    press(Qt::Key_Z, Qt::ControlModifier);
    press(Qt::Key_K);
    EXPECT_EQ(cell(0, TruthRows::Nudge), "−60 mm along");
    press(Qt::Key_0);
    EXPECT_EQ(page->view()->scene().side[0][9].height, before[9].height);
    for (int i = 0; i < 5; ++i) page->backButton()->click();
    EXPECT_EQ(page->view()->scene().side[0][9].height, moved[9].height);
    press(Qt::Key_Period);
    for (const std::size_t bin : {0U, 5U, 9U, 10U})
        EXPECT_NEAR(*page->view()->scene().side[0].at(bin).height, *moved.at(bin).height, 0.002)
            << "the next scene is 0.1 m ahead; bin " << bin;

    const std::string out = directory.file("moved.csv");
    page->exportTo(QString::fromStdString(out));
    const auto scenes = readTwoTrackScenes(out);
    ASSERT_TRUE(scenes) << scenes.error().text;
    EXPECT_EQ(scenes->scenes[0].truth[0][9], moved[9].height);
    EXPECT_EQ(saved()[0].along, -0.1);
}

TEST_F(TruthBench, filesWithoutCellsSayWhyTheyCannotBeNudgedAlong)
{
    SqliteFile older = SqliteFile::fill(file);
    for (const char* const sql :
         {"ALTER TABLE scene RENAME TO newer",
          "CREATE TABLE scene(number INTEGER PRIMARY KEY, csv TEXT NOT NULL, gap TEXT NOT NULL, "
          "cloud_m REAL, slice BLOB NOT NULL) STRICT",
          "INSERT INTO scene SELECT number, csv, gap, cloud_m, x'0100e80338ff' FROM newer",
          "DROP TABLE newer", "DROP TABLE rule", "PRAGMA user_version = 1"})
        older.run(sql);
    older.close();
    open();
    EXPECT_FALSE(page->aheadButton()->isEnabled());
    EXPECT_FALSE(page->backButton()->isEnabled());
    press(Qt::Key_K);
    EXPECT_TRUE(page->stateLabel()->text().contains("written by an earlier version"))
        << page->stateLabel()->text().toStdString();
    EXPECT_EQ(cell(0, TruthRows::Decision), "open");
    press(Qt::Key_U);
    EXPECT_EQ(cell(0, TruthRows::Nudge), "+5 mm") << "the other nudges act";
    window.reset();
    ASSERT_TRUE(writeFileAtomically(file + ".decisions.csv",
                                    "row,run,decision,offset_m,tilt_rad,along_m\n"
                                    "1,,accept,,,0.02\n"));
    open();
    EXPECT_TRUE(page->stateLabel()->text().contains("line 2: along_m moves the cloud"))
        << page->stateLabel()->text().toStdString();
}

TEST_F(TruthBench, undoTakesDecisionsBackInOrder)
{
    open();
    EXPECT_FALSE(page->undoButton()->isEnabled());
    press(Qt::Key_X);
    press(Qt::Key_U);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(cell(1, TruthRows::Nudge), "");
    EXPECT_EQ(cell(1, TruthRows::Decision), "open");
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(cell(0, TruthRows::Decision), "open");
    EXPECT_EQ(page->scene(), 0U);
    EXPECT_FALSE(page->undoButton()->isEnabled());
}

TEST_F(TruthBench, decisionsAreSavedAndReadAgain)
{
    open();
    const auto before = readFile(file, 1U << 30U);
    press(Qt::Key_X);
    press(Qt::Key_U);
    ASSERT_TRUE(eventually([&] { return saved().size() == 2; }))
        << page->stateLabel()->text().toStdString();
    EXPECT_EQ(saved()[1].offset, 0.005);
    press(Qt::Key_A);
    window.reset();  // saves at once
    open();
    EXPECT_EQ(cell(0, TruthRows::Decision), "excluded");
    EXPECT_EQ(cell(1, TruthRows::Nudge), "+5 mm");
    EXPECT_EQ(page->scene(), 2U) << "the first open scene";
    EXPECT_EQ(*readFile(file, 1U << 30U), *before);
}

TEST_F(TruthBench, decisionsFileOfOtherScenesIsLeftAlone)
{
    const std::string text = "row,run,decision,offset_m,tilt_rad\n9,,exclude,,\n";
    ASSERT_TRUE(writeFileAtomically(file + ".decisions.csv", text));
    open();
    EXPECT_TRUE(page->stateLabel()->text().contains("row 9 does not exist"))
        << page->stateLabel()->text().toStdString();
    EXPECT_FALSE(page->acceptButton()->isEnabled());
    press(Qt::Key_X);
    window.reset();
    EXPECT_EQ(*readFile(file + ".decisions.csv", 1000), text);
}

TEST_F(TruthBench, exportHasTheDecisionsAndOverwritesNothing)
{
    open();
    press(Qt::Key_X);
    const std::string out = directory.file("accepted.csv");
    page->exportTo(QString::fromStdString(out));
    const auto scenes = readTwoTrackScenes(out);
    ASSERT_TRUE(scenes) << scenes.error().text;
    ASSERT_EQ(scenes->scenes.size(), 4U);
    EXPECT_EQ(knownHeights(scenes->scenes[0].truth), 0);
    EXPECT_EQ(knownHeights(scenes->scenes[1].truth), 22);
    ASSERT_TRUE(scenes->scenes[1].truthSd[0][0]);
    for (const std::string& taken : {out, file}) {
        const auto before = readFile(taken, 1U << 30U);
        page->exportTo(QString::fromStdString(taken));
        EXPECT_TRUE(page->stateLabel()->text().contains("exists already"));
        EXPECT_EQ(*readFile(taken, 1U << 30U), *before);
    }
}

TEST_F(TruthBench, exportIsProposedInTheDocumentsUnderAFreeName)
{
    const OwnDocuments documents(directory.file("home"));
    const QString taken = documents.folder() + "/drive_accepted.csv";
    ASSERT_TRUE(writeFileAtomically(taken.toStdString(), "another export"));
    open();
    page->exportButton()->click();
    const auto* const dialog = page->findChild<QFileDialog*>();
    ASSERT_TRUE(dialog);
    EXPECT_EQ(dialog->directory().absolutePath(), documents.folder());
    EXPECT_EQ(dialog->selectedFiles(), QStringList(documents.folder() + "/drive_accepted-2.csv"));
}

TEST_F(TruthBench, keyboardReachesEveryControl)
{
    open();
    press(Qt::Key_U);
    page->table()->setFocus();
    std::set<const QWidget*> reached;
    for (int i = 0; i < 28; ++i) {
        reached.insert(QApplication::focusWidget());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    for (const QPushButton* control : page->findChildren<QPushButton*>()) {
        EXPECT_TRUE(reached.contains(control)) << control->text().toStdString();
        EXPECT_FALSE(control->accessibleName().isEmpty());
    }
    EXPECT_TRUE(reached.contains(page->table()));
    EXPECT_TRUE(reached.contains(page->sidesChoice()));
}

TEST_F(TruthBench, kindIsKnownByTheContent)
{
    EXPECT_EQ(kindOfFile(QString::fromStdString(file)), FileKind::Truth);
}

TEST_F(TruthBench, isReadableInEveryThemeAndSize)
{
    for (const QSize size : {QSize(1024, 600), QSize(1200, 680)})
        for (const ThemeName theme :
             {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast}) {
            applyLook(*qApp, theme);
            open();
            window->setRoom(size);
            ASSERT_TRUE(eventually([&] { return !window->isFittingFont(); }));
            window->resize(size);
            EXPECT_LE(window->minimumHeight(), size.height());
            EXPECT_LE(window->minimumWidth(), size.width());
            EXPECT_EQ(page->table()->horizontalScrollBar()->maximum(), 0) << "it scrolls sideways";
            EXPECT_FALSE(page->table()->isColumnHidden(TruthRows::Decision));
            press(Qt::Key_X);
            press(Qt::Key_U);
            const QByteArray folder = qgetenv("TERRATACT_PICTURES");
            if (!folder.isEmpty())
                window->grab().save(QStringLiteral("%1/truth_%2_%3.png")
                                        .arg(QString::fromLocal8Bit(folder))
                                        .arg(size.width())
                                        .arg(static_cast<int>(theme)));
            for (const QPushButton* control : page->findChildren<QPushButton*>()) {
                EXPECT_TRUE(control->isVisible());
                EXPECT_GE(control->width(), control->minimumSizeHint().width());
                EXPECT_EQ(page->sidesChoice()->height(), control->height())
                    << "the list looks like the buttons beside it";
            }
        }
}

}  // namespace
}  // namespace terratact
