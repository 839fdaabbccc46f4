// Tests the browser of recordings as its user sees it.
#include "app/sessions/session_browser.h"

#include <gtest/gtest.h>

#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <filesystem>

#include "app/sessions/session_details.h"
#include "app/sessions/session_list.h"
#include "app/sessions/session_list_view.h"
#include "app/shell/preferences/preference_store.h"
#include "core/log/session_writer.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

using gui::eventually;
namespace fs = std::filesystem;

struct Browser : testing::Test {
    Browser() { applyLook(*qApp); }
    ~Browser() override
    {
        browser.reset();
        applyLook(*qApp);
    }
    std::string make(const std::string& name, std::int64_t laterBy = 0)
    {
        const std::string path = directory.file(name);
        SessionStart start = someStart();
        start.wallTime += laterBy * 1'000'000'000;
        start.robot = contentOf(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
        auto writer = SessionWriter::create(path, start);
        EXPECT_TRUE(writer);
        EXPECT_TRUE(writer->add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
        EXPECT_TRUE(writer->add(someScene(1, 1'000'000)));
        EXPECT_TRUE(writer->add(someEstimate(1, 2'000'000)));
        EXPECT_TRUE(writer->add(EventRow{.kind = EventKind::Marker, .text = "note of " + name}));
        EXPECT_TRUE(writer->seal());
        return path;
    }
    std::string folder() const { return fs::path(directory.file("x")).parent_path().string(); }
    void open(const std::string& recorded = {})
    {
        browser = std::make_unique<SessionBrowser>(
            BrowserWish{.folder = QString::fromStdString(folder()),
                        .recorded = recorded,
                        .store = &store,
                        .opens = [this](const QString& path) { opened << path; },
                        .asksForFile = [this] { ++asked; }},
            nullptr);
        browser->resize(1100, 600);
        gui::showActive(*browser);
        ASSERT_TRUE(eventually([&] { return browser->isRead(); }));
    }
    QString file(int row) const
    {
        return QString::fromStdString(fs::path(browser->sessions().at(row).path).filename());
    }
    int rows() const { return browser->sessions().rowCount(); }

    TemporaryDirectory directory;
    PreferenceStore store;
    std::unique_ptr<SessionBrowser> browser;
    QStringList opened;
    int asked = 0;
};

TEST_F(Browser, listsTheNewestFirstAndABrokenFileWithItsReason)
{
    make("a.tts", 100);
    make("b.tts", 200);
    fs::path broken = directory.write("c.tts", std::string(300, 'x'));
    fs::last_write_time(broken, fs::file_time_type::clock::now() - std::chrono::hours(1000000));
    open();
    ASSERT_EQ(rows(), 3);
    EXPECT_EQ(file(0), "b.tts");
    EXPECT_EQ(file(1), "a.tts");
    EXPECT_EQ(file(2), "c.tts");
    const QString reason = browser->sessions().index(2, SessionList::Robot).data().toString();
    EXPECT_TRUE(reason.contains("is not an SQLite file")) << reason.toStdString();
    EXPECT_TRUE(eventually([&] {
        return browser->table()->columnSpan(2, SessionList::Robot) == 4
            && browser->table()->columnSpan(1, SessionList::Robot) == 1;
    })) << "the reason has room";
    EXPECT_EQ(browser->stateLabel()->text(), "recordings: 3");
    EXPECT_EQ(browser->table()->currentIndex().row(), 0) << "the newest is chosen";
    EXPECT_TRUE(browser->details()->text().contains("note of b.tts"));
    QTest::keyClick(browser->table(), Qt::Key_Down);
    EXPECT_TRUE(browser->details()->text().contains("note of a.tts"));
}

TEST_F(Browser, keysOpenSearchSortAndClose)
{
    make("a.tts", 100);
    const std::string b = make("b.tts", 200);
    open();
    ASSERT_TRUE(browser->table()->hasFocus());
    QTest::keyClick(browser->table(), Qt::Key_Slash);
    EXPECT_TRUE(browser->searchEdit()->hasFocus());
    QTest::keyClicks(browser->searchEdit(), "a.tts");
    ASSERT_EQ(rows(), 1);
    EXPECT_EQ(file(0), "a.tts");
    EXPECT_EQ(browser->stateLabel()->text(), "1 of 2 recordings match");
    QTest::keyClicks(browser->searchEdit(), "/");
    EXPECT_EQ(browser->searchEdit()->text(), "a.tts/") << "a slash can be searched for";
    EXPECT_FALSE(browser->openButton()->isEnabled());
    EXPECT_TRUE(browser->details()->text().contains("No recording matches"));
    browser->searchEdit()->clear();
    browser->table()->selectRow(0);
    QTest::keyClick(browser->searchEdit(), Qt::Key_Down);
    EXPECT_EQ(browser->table()->currentIndex().row(), 1);
    QTest::keyClick(browser->table(), Qt::Key_2, Qt::AltModifier);
    EXPECT_EQ(file(0), "a.tts") << "sorted by the begin, the oldest first";
    QTest::keyClick(browser->table(), Qt::Key_2, Qt::AltModifier);
    EXPECT_EQ(file(0), "b.tts");
    browser->table()->selectRow(0);
    QTest::keyClick(browser->searchEdit(), Qt::Key_Return);
    EXPECT_EQ(opened, QStringList{QString::fromStdString(b)});
    EXPECT_FALSE(browser->isVisible());
    open();
    QTest::keyClick(browser->table(), Qt::Key_Return);
    EXPECT_EQ(opened.size(), 2);
    open();
    QTest::keyClick(browser->table(), Qt::Key_Escape);
    EXPECT_FALSE(browser->isVisible());
    EXPECT_EQ(opened.size(), 2);
}

TEST_F(Browser, everyControlHasANameAndIsReachedByTab)
{
    make("a.tts");
    open();
    std::set<const QWidget*> reached;
    for (int i = 0; i < 12; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        reached.insert(QApplication::focusWidget());
    }
    for (const QWidget* const wanted : std::initializer_list<QWidget*>{
             browser->table(), browser->searchEdit(), browser->openButton(), browser->otherButton(),
             browser->folderButton()})
        EXPECT_TRUE(reached.contains(wanted));
    EXPECT_FALSE(browser->table()->accessibleName().isEmpty());
    EXPECT_FALSE(browser->searchEdit()->accessibleName().isEmpty());
}

TEST_F(Browser, otherFilesAreAskedForAndTheFolderIsRemembered)
{
    make("a.tts");
    fs::create_directory(directory.file("empty"));
    open();
    QTest::mouseClick(browser->folderButton(), Qt::LeftButton);
    auto* dialog = browser->findChild<QFileDialog*>();
    ASSERT_TRUE(dialog);
    EXPECT_EQ(dialog->fileMode(), QFileDialog::Directory);
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    const QString empty = QString::fromStdString(directory.file("empty"));
    emit dialog->fileSelected(empty);
    dialog->reject();
    ASSERT_TRUE(eventually([&] { return browser->isRead(); }));
    EXPECT_EQ(rows(), 0);
    EXPECT_TRUE(browser->details()->text().contains("holds no recording"));
    EXPECT_EQ(store.current().sessionFolder, empty);
    open();
    EXPECT_EQ(browser->folder(), empty) << "at the next start, too";
    QTest::mouseClick(browser->otherButton(), Qt::LeftButton);
    EXPECT_EQ(asked, 1);
    EXPECT_FALSE(browser->isVisible());
    fs::remove(directory.file("empty"));
    open();
    EXPECT_EQ(browser->folder().toStdString(), folder()) << "the remembered one is gone";
}

TEST_F(Browser, aFolderThatCannotBeReadIsNamed)
{
    open();
    browser->showFolder("/nowhere");
    ASSERT_TRUE(eventually([&] { return browser->isRead(); }));
    EXPECT_TRUE(browser->stateLabel()->text().contains("/nowhere"))
        << browser->stateLabel()->text().toStdString();
}

TEST_F(Browser, theFileBeingRecordedIsListedWithoutOpeningIt)
{
    const std::string path = directory.file("now.tts");
    auto writer = someSession(path, 300);
    ASSERT_TRUE(writer);
    open(path);
    ASSERT_EQ(rows(), 1);
    EXPECT_FALSE(browser->sessions().at(0).summary);
    EXPECT_EQ(browser->sessions().index(0, SessionList::State).data(), "● being recorded");
    EXPECT_TRUE(browser->details()->text().contains("is recording it"));
}

TEST_F(Browser, closingEndsTheReadingOfManyFiles)
{
    const std::string one = make("0.tts");
    for (int i = 1; i < 3000; ++i)
        fs::create_hard_link(one, directory.file(std::to_string(i) + ".tts"));
    browser = std::make_unique<SessionBrowser>(
        BrowserWish{.folder = QString::fromStdString(folder())}, nullptr);
    gui::showActive(*browser);
    ASSERT_TRUE(eventually([&] { return rows() > 0; }));
    EXPECT_FALSE(browser->isRead()) << "the first rows are shown while others are read";
    const QPointer<SessionBrowser> gone = browser.get();
    QElapsedTimer clock;
    clock.start();
    browser.reset();
    EXPECT_LT(clock.elapsed(), 500);
    EXPECT_TRUE(gone.isNull());
    for (const auto& entry : fs::directory_iterator(folder()))
        ASSERT_EQ(entry.path().extension(), ".tts") << "nothing is left beside a recording";
}

/// TERRATACT_PICTURES=folder saves a picture in each theme, and one of a small window.
TEST_F(Browser, fitsASmallScreenInEveryTheme)
{
    for (int i = 0; i < 12; ++i) make("drive" + std::to_string(i) + ".tts", 40'000 * i);
    for (const char* const name : {"demo", "two_tracks"})
        fs::copy_file(TERRATACT_SOURCE_DIR "/resources/sessions/" + std::string(name) + ".tts",
                      directory.file(name + std::string(".tts")));
    directory.write("stranger.tts", std::string(300, 'x'));
    fs::resize_file(make("torn.tts", 500'000), 20'000);
    const QString pictures = qEnvironmentVariable("TERRATACT_PICTURES");
    for (const ThemeName theme : {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast})
        for (const QSize size : {QSize(1120, 640), QSize(1000, 470)}) {
            applyLook(*qApp, theme, size.height() < 500 ? 85 : 100);
            open();
            browser->resize(size);
            browser->table()->selectRow(2);
            QTest::qWait(30);
            EXPECT_EQ(browser->size(), size) << "it needs no more room";
            EXPECT_GE(browser->table()->viewport()->height(),
                      3 * browser->table()->verticalHeader()->defaultSectionSize());
            if (!pictures.isEmpty())
                browser->grab().save(QStringLiteral("%1/browser-%2-%3.png")
                                         .arg(pictures, QString::fromUtf8(terratact::name(theme)))
                                         .arg(size.width()));
        }
}

}  // namespace
}  // namespace terratact
