// Tests the training page in the whole console, through real mouse and key events.
#include "app/console/pages/training_page.h"

#include <dirent.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QTableWidget>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

#include "app/console/main_window.h"
#include "app/console/pages/settings_page.h"
#include "app/display/translated.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/model/file/model_file.h"
#include "core/learn/model/model_card.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_model.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/status_header.h"

namespace terratact {
namespace {

using gui::eventually;

constexpr int kPatience = 180000;  // [ms] for steps that take seconds on an idle machine

/// Returns how many threads of this process have this nice value.
int threadsOfNice(int nice)
{
    int count = 0;
    const std::unique_ptr<DIR, int (*)(DIR*)> tasks(opendir("/proc/self/task"), closedir);
    while (const dirent* task = readdir(tasks.get()))
        if (const int id = std::atoi(task->d_name); id > 0)
            count += getpriority(PRIO_PROCESS, static_cast<id_t>(id)) == nice ? 1 : 0;
    return count;
}

struct TrainingConsole : testing::Test {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
        files = new TemporaryDirectory;
        EXPECT_TRUE(writeModel(files->file("old.ttm"), toyModel(4)));
        EXPECT_TRUE(writeScenes(files->file("learn.csv"), someScenes(4, 1)));
        EXPECT_TRUE(writeScenes(files->file("test.csv"), someScenes(2, 7)));
        const std::vector<Scene> learnt = someScenes(4, 1);
        EXPECT_TRUE(writeScenes(files->file("subset.csv"), {learnt.begin(), learnt.begin() + 4}));
    }
    static void TearDownTestSuite() { delete std::exchange(files, nullptr); }

    void SetUp() override
    {
        qputenv("XDG_DATA_HOME", QByteArray::fromStdString(data.file("share")));
        models = data.file("share/terratact/models");
        open({.threads = 2, .nice = 0});
    }
    void TearDown() override
    {
        window.reset();
        qunsetenv("XDG_DATA_HOME");
    }
    void open(TrainingLoad load)
    {
        window.reset();
        MainWindow::Options options;
        options.robot = robot;
        auto scripted = std::make_unique<ScriptedSource>();
        source = scripted.get();
        options.source = std::move(scripted);
        options.modelPath = files->file("old.ttm");
        options.model = modelFileLoader(options.modelPath, robot);
        options.exploration.linkLostAfter = 60.0;  // long, because the machine may be busy
        options.exploration.settings.draws = 50;
        options.exploration.limits.halt = 600.0;
        options.training = load;
        window = std::make_unique<MainWindow>(std::move(options));
        window->resize(1200, 680);
        gui::showActive(*window);
        page = window->training();
        page->discardButton()->setHoldTime(100);
        page->adoptButton()->setHoldTime(100);
        QTest::keyClick(window.get(), Qt::Key_F6);
        EXPECT_TRUE(page->isVisible());
        EXPECT_TRUE(eventually([&] { return modelInUse() == "old.ttm"; }, kPatience));
    }

    static void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
    static void type(QLineEdit* field, const std::string& text)
    {
        click(field);
        field->selectAll();
        QTest::keyClicks(field, QString::fromStdString(text));
    }
    void train(const std::string& scenes)
    {
        type(page->scenesField(), scenes);
        ASSERT_TRUE(page->startButton()->isEnabled()) << said();
        click(page->startButton());
    }
    bool ends() const
    {
        return eventually([&] { return !page->cancelButton()->isEnabled(); }, kPatience);
    }
    std::string said() const { return page->status()->text().toStdString(); }
    void trainAndCompare(const std::string& test = "test.csv")
    {
        train(files->file("learn.csv"));
        ASSERT_TRUE(ends());
        ASSERT_TRUE(said().starts_with("Trained on")) << said();
        type(page->testField(), files->file(test));
        ASSERT_TRUE(page->compareButton()->isEnabled());
        EXPECT_FALSE(page->adoptButton()->isEnabled()) << "not before it was compared";
        EXPECT_TRUE(page->reason()->text().contains("Compare"));
        click(page->compareButton());
        ASSERT_TRUE(ends());
        ASSERT_TRUE(said().starts_with("Compared on")) << said();
    }
    /// Returns the model named by the preconditions of exploring.
    std::string modelInUse() const
    {
        for (const Precondition& p : window->exploration().preconditions())
            if (translated(p.text).startsWith("model ") && translated(p.text).endsWith(" is ready"))
                return translated(p.text).mid(6, translated(p.text).size() - 15).toStdString();
        return {};
    }
    std::set<std::string> written() const
    {
        std::set<std::string> names;
        if (std::filesystem::exists(models))
            for (const auto& entry : std::filesystem::directory_iterator(models))
                names.insert(entry.path().filename());
        return names;
    }

    static inline TemporaryDirectory* files = nullptr;
    TemporaryDirectory data;
    std::string models;
    RobotModel robot = absolem();
    std::unique_ptr<MainWindow> window;
    ScriptedSource* source = nullptr;
    TrainingPage* page = nullptr;
};

TEST_F(TrainingConsole, trainsComparesAndAdopts)
{
    EXPECT_TRUE(gui::cutText(*page).empty()) << gui::cutText(*page).front();
    EXPECT_FALSE(page->startButton()->isEnabled());
    EXPECT_FALSE(page->compareButton()->isEnabled());
    EXPECT_FALSE(page->adoptButton()->isEnabled());
    gui::TipsOfButtons tips;
    tips.poll(*page);
    train(files->file("learn.csv"));
    EXPECT_TRUE(
        eventually([&] { return page->bins()->item(0, 1)->text().startsWith("done"); }, kPatience));
    EXPECT_EQ(page->bins()->item(10, 6)->text(), "waiting");
    EXPECT_TRUE(page->bar()->format().contains("left")) << page->bar()->format().toStdString();
    EXPECT_FALSE(page->startButton()->isEnabled());
    tips.poll(*page);
    ASSERT_TRUE(ends());
    tips.poll(*page);
    for (int bin = 0; bin < kBins; ++bin)
        for (int kind = 1; kind <= 6; ++kind) {
            const QString text = page->bins()->item(bin, kind)->text();
            EXPECT_TRUE(text.startsWith("done") || text == "too few") << text.toStdString();
        }
    EXPECT_EQ(written(), (std::set<std::string>{"trained-1.ttm", "trained-1.card.toml"}));
    EXPECT_EQ(page->nameField()->text(), "trained-2");

    type(page->testField(), files->file("test.csv"));
    tips.poll(*page);
    click(page->compareButton());
    tips.poll(*page);
    ASSERT_TRUE(ends());
    EXPECT_TRUE(page->verdict()->isVisible());
    EXPECT_TRUE(page->verdict()->text().contains("Near the robot "));
    for (int row = 0; row < page->comparison()->rowCount(); ++row)
        for (int column = 1; column < 4; ++column)
            EXPECT_NE(page->comparison()->item(row, column)->text(), "--");
    EXPECT_TRUE(gui::cutText(*page).empty()) << gui::cutText(*page).front();

    // A robot that keeps driving, so that the exploration never ends halting.
    Measurement driving;  // it never halts
    driving.activity = RobotActivity::Driving;
    source->setMeasurement(driving);
    window->exploration().request();
    ASSERT_TRUE(eventually([&] { return !page->adoptButton()->isEnabled(); }));
    EXPECT_TRUE(page->reason()->text().contains("exploration is running"));
    tips.poll(*page);
    QTest::mousePress(page->adoptButton(), Qt::LeftButton);
    QTest::qWait(300);  // waits for an event that must not come
    QTest::mouseRelease(page->adoptButton(), Qt::LeftButton);
    EXPECT_EQ(modelInUse(), "old.ttm");
    page->setFocus();
    QTest::keyClick(window.get(), Qt::Key_Escape);
    ASSERT_TRUE(eventually([&] { return page->adoptButton()->isEnabled(); }));
    tips.poll(*page);
    EXPECT_EQ(tips.silent(), std::vector<std::string>());
    for (const char* name :
         {"Start", "Cancel", "Compare", "Use the new model from now on", "Discard the new model",
          "Choose the training scenes", "Choose the test scenes"})
        EXPECT_TRUE(tips.compared().contains(name)) << name;

    click(page->adoptButton());
    EXPECT_EQ(modelInUse(), "old.ttm") << "a click is no hold";
    QTest::mousePress(page->adoptButton(), Qt::LeftButton);
    ASSERT_TRUE(eventually([&] { return modelInUse() == "trained-1.ttm"; }, kPatience)) << said();
    QTest::mouseRelease(page->adoptButton(), Qt::LeftButton);
    EXPECT_TRUE(eventually([&] { return said() == "trained-1.ttm is in use now"; })) << said();
    EXPECT_EQ(page->modelInUse().toStdString(), models + "/trained-1.ttm");
    EXPECT_TRUE(
        window->header()->qualityButton()->menu()->actions().first()->text().contains("not "
                                                                                      "measured"));
    const auto model = readModel(models + "/trained-1.ttm");
    ASSERT_TRUE(model);
    EXPECT_NE(model->data.command.find("page Training"), std::string::npos);

    const auto card = readModelCard(models + "/trained-1.ttm", model->contentHash);
    ASSERT_TRUE(card && *card);
    EXPECT_EQ((*card)->terrain, "learn.csv");
    ASSERT_EQ((*card)->scores.size(), 1U);
    EXPECT_EQ((*card)->scores.front().data, "test.csv");
    const auto shows = [&](const char* words) {
        return eventually([&] { return window->settings()->modelCard().contains(words); });
    };
    QTest::keyClick(window.get(), Qt::Key_F7);
    EXPECT_TRUE(shows("ground: learn.csv"));
    EXPECT_TRUE(shows("scenes of test.csv"));
}

TEST_F(TrainingConsole, theCardCountsTrainingScenes)
{
    trainAndCompare("subset.csv");
    const auto model = readModel(models + "/trained-1.ttm");
    ASSERT_TRUE(model);
    const auto card = readModelCard(models + "/trained-1.ttm", model->contentHash);
    ASSERT_TRUE(card && *card);
    ASSERT_EQ((*card)->scores.size(), 1U);
    const CardScores& scores = (*card)->scores.front();
    EXPECT_GT(scores.scenes, 0U);
    EXPECT_EQ(scores.trainingScenes, scores.scenes);
}

TEST_F(TrainingConsole, aCancelledTrainingLeavesNoFile)
{
    train(files->file("learn.csv"));
    EXPECT_TRUE(eventually([&] { return page->bins()->item(0, 1)->text() != "waiting"; }));
    page->cancelButton()->setFocus();
    QTest::keyClick(page->cancelButton(), Qt::Key_Space);
    ASSERT_TRUE(ends());
    EXPECT_EQ(said(), "Cancelled: nothing was written");
    EXPECT_EQ(written(), std::set<std::string>{});
    EXPECT_TRUE(page->startButton()->isEnabled());
    EXPECT_FALSE(page->discardButton()->isEnabled());
}

TEST_F(TrainingConsole, closingInTheMiddleLeavesNoFile)
{
    train(files->file("learn.csv"));
    EXPECT_TRUE(eventually([&] { return page->bins()->item(0, 1)->text() != "waiting"; }));
    window.reset();
    EXPECT_EQ(written(), std::set<std::string>{});
}

TEST_F(TrainingConsole, namesTheLineAtFaultInAFile)
{
    std::string text = contentOf(files->file("learn.csv"));
    text.insert(text.find('\n') + 1, "1,");
    const std::string bad = data.write("bad.csv", text);
    train(bad);
    ASSERT_TRUE(ends());
    EXPECT_TRUE(said().starts_with(bad + ": line 2")) << said();
    EXPECT_EQ(written(), std::set<std::string>{});
    EXPECT_TRUE(eventually([&] { return gui::cutText(*page).empty(); }));
}

TEST_F(TrainingConsole, refusesANameThatIsTaken)
{
    std::filesystem::create_directories(models);
    data.write("share/terratact/models/mine.ttm", "precious");
    type(page->scenesField(), files->file("learn.csv"));
    type(page->nameField(), "../mine");
    EXPECT_EQ(page->nameField()->text(), "mine") << "no way out of the directory";
    EXPECT_FALSE(page->startButton()->isEnabled());
    EXPECT_TRUE(said().find("mine.ttm exists already") != std::string::npos) << said();
    type(page->nameField(), "mine-2");
    EXPECT_TRUE(page->startButton()->isEnabled());
    EXPECT_EQ(contentOf(models + "/mine.ttm"), "precious");
}

TEST_F(TrainingConsole, discardDeletesTheNewModelOnly)
{
    trainAndCompare();
    QTest::mousePress(page->discardButton(), Qt::LeftButton);
    EXPECT_TRUE(eventually([&] { return written().empty(); }));
    QTest::mouseRelease(page->discardButton(), Qt::LeftButton);
    EXPECT_EQ(said(), "trained-1.ttm discarded");
    EXPECT_FALSE(page->adoptButton()->isEnabled());
    EXPECT_FALSE(page->verdict()->isVisible());
    EXPECT_EQ(modelInUse(), "old.ttm");
}

TEST_F(TrainingConsole, aModelThatCannotBeLoadedLeavesTheOldOne)
{
    trainAndCompare();
    data.write("share/terratact/models/trained-1.ttm", "torn");
    QTest::mousePress(page->adoptButton(), Qt::LeftButton);
    ASSERT_TRUE(eventually([&] { return said().starts_with("Not adopted"); })) << said();
    QTest::mouseRelease(page->adoptButton(), Qt::LeftButton);
    EXPECT_NE(said().find("trained-1.ttm"), std::string::npos);
    EXPECT_EQ(modelInUse(), "old.ttm");
    EXPECT_EQ(page->modelInUse().toStdString(), files->file("old.ttm"));
    EXPECT_TRUE(window->modelTrouble().isEmpty());
}

TEST_F(TrainingConsole, stopWorksByKeyAndByMouseBesideTheFileDialog)
{
    click(page->scenesButton());
    QFileDialog* dialog = nullptr;
    ASSERT_TRUE(eventually([&] {
        dialog = page->findChild<QFileDialog*>();
        return dialog && dialog->isVisible();
    }));
    EXPECT_TRUE(QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs));
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    ASSERT_TRUE(name);
    source->consumeCommands();
    QTest::keyClick(name, Qt::Key_F12);
    const auto commands = source->consumeCommands();
    ASSERT_FALSE(commands.empty());
    EXPECT_TRUE(std::holds_alternative<StopCommand>(commands.front()));
    int stops = 0;
    QObject::connect(&window->exploration(), &Exploration::decided, window.get(),
                     [&stops](const char* what) { stops += std::string_view(what) == "stop"; });
    const QPushButton& stop = *window->header()->stopButton();
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {},
                      stop.mapTo(window.get(), stop.rect().center()));
    EXPECT_EQ(stops, 1) << "nor does the dialog block the mouse";

    name->setFocus();
    name->setText(QString::fromStdString(files->file("learn.csv")));
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_TRUE(eventually(
        [&] { return page->scenesField()->text().toStdString() == files->file("learn.csv"); }));
}

TEST_F(TrainingConsole, trainingWaitsBehindTheLiveConsole)
{
    const TrainingLoad polite = politeLoad();
    EXPECT_EQ(polite.nice, 19);
    EXPECT_GE(polite.threads, 1);
    open({.threads = 2, .nice = 19});
    EXPECT_EQ(threadsOfNice(19), 1);
    train(files->file("learn.csv"));
    EXPECT_TRUE(eventually([&] { return threadsOfNice(19) == 2; }, kPatience))
        << "a thread that training starts is as polite";
    EXPECT_NE(getpriority(PRIO_PROCESS, 0), 19) << "the window's is not";
    click(page->cancelButton());
    EXPECT_TRUE(ends());
}

}  // namespace
}  // namespace terratact
