// Tests the DBC files of the signals page.
#include "app/pages/dbc_files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "app/console/pages/signals_page.h"
#include "app/runtime/steady_now.h"
#include "app/shell/preferences/preference_store.h"
#include "tests/support/benches/pages_bench.h"
#include "tests/support/gui.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(ForeignFramesOnThePage, aBadDbcFileIsReportedAndStopsNothing)
{
    open({file("gas.dbc"), file("clash.dbc"), file("bad.dbc"), file("none.dbc")});
    QTest::keyClick(window.get(), Qt::Key_F5);
    ASSERT_TRUE(eventually([&] { return valueOf("Oxygen") == "20.71"; }));
    const SignalsPage* page = window->signalsPage();
    EXPECT_EQ(page->dbc()->files(),
              "DBC files: gas.dbc (frames: 2), clash.dbc (frames: 0), bad.dbc (not "
              "used), none.dbc (not used)");
    const QStringList troubles = page->dbc()->troubles().split('\n');
    ASSERT_EQ(troubles.size(), 4);
    EXPECT_TRUE(troubles[0].contains("bad.dbc: describes no message"));
    EXPECT_TRUE(troubles[0].contains("line 1: expected the keyword"));
    EXPECT_TRUE(troubles[1].contains("none.dbc: cannot be opened"));
    EXPECT_TRUE(troubles[2].contains(
        "frame 022: ignored; the robot's protocol already uses this identifier"));
    EXPECT_EQ(troubles[3], QString::fromUtf8("… and 1 more, all listed in this tooltip"));
    const QList<QLabel*> labels = page->findChildren<QLabel*>();
    const auto label = std::ranges::find_if(labels, [](const QLabel* at) {
        return terratact::tipOf(*at).contains("bad.dbc: describes");
    });
    ASSERT_NE(label, labels.end());
    const QString tip = terratact::tipOf(**label);
    EXPECT_EQ(tip.count('\n'), 3) << tip.toStdString();
    EXPECT_FALSE(tip.contains("<p ")) << "it is escaped once at most: " << tip.toStdString();
    EXPECT_TRUE(eventually([&] { return valueOf("Pitch") != "--"; })) << "the protocol wins";
    window->resize(window->minimumSize());
    QTest::qWait(300);
    picture("signals-foreign-troubles");
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
}

TEST_F(ForeignFramesOnThePage, dbcFilesCanBeAddedAndRemovedWhileRunning)
{
    open();
    QTest::keyClick(window.get(), Qt::Key_F5);
    const SignalsPage* page = window->signalsPage();
    EXPECT_TRUE(page->dbc()->addButton()->isVisible());
    EXPECT_FALSE(page->dbc()->removeButton()->isVisible());
    ASSERT_TRUE(eventually([&] { return window->link()->tap().frames(steadyNow()).size() > 10; }));
    QTest::mouseClick(page->dbc()->addButton(), Qt::LeftButton);
    auto* dialog = page->findChild<QFileDialog*>();
    ASSERT_TRUE(dialog);
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file("gas.dbc"));
    QMetaObject::invokeMethod(dialog, "accept");
    ASSERT_TRUE(eventually([&] { return valueOf("Oxygen") == "20.71"; }));
    EXPECT_EQ(window->preferences().current().dbc, QStringList{file("gas.dbc")}) << "remembered";
    ASSERT_TRUE(page->dbc()->removeButton()->isVisible());
    ASSERT_EQ(page->dbc()->removeButton()->menu()->actions().size(), 1);
    page->dbc()->removeButton()->menu()->actions().first()->trigger();
    EXPECT_TRUE(eventually([&] { return valueOf("Oxygen") == "no such signal"; }));
    EXPECT_EQ(window->preferences().current().dbc, QStringList());
    EXPECT_FALSE(page->dbc()->removeButton()->isVisible());

    window->preferences().change([&](Preferences& p) { p.dbc << file("gas.dbc"); });
    EXPECT_FALSE(page->dbc()->removeButton()->isVisible()) << "no file is read in this thread";
    EXPECT_TRUE(eventually([&] { return page->dbc()->removeButton()->isVisible(); }));
}

/// A file whose reader blocks until it is released, like on an unresponsive network share.
class SlowFile {
public:
    explicit SlowFile(const std::string& path) : fd_(::open(path.c_str(), O_RDWR | O_CLOEXEC))
    {
        std::signal(SIGIO, SIG_IGN);  // the kernel requests the lease with it
        waits_ = fd_ >= 0 && ::fcntl(fd_, F_SETLEASE, F_WRLCK) == 0;
    }
    ~SlowFile()
    {
        letGo();
        if (fd_ >= 0) ::close(fd_);
    }
    SlowFile(const SlowFile&) = delete;
    SlowFile& operator=(const SlowFile&) = delete;
    bool waits() const { return waits_; }
    void letGo() const { (void)::fcntl(fd_, F_SETLEASE, F_UNLCK); }

private:
    int fd_;
    bool waits_ = false;
};

TEST_F(ForeignFramesOnThePage, closingWaitsForAtMostOneDbcFile)
{
    using namespace std::chrono_literals;
    constexpr double kHang = 20.0;  // [s]; the kernel blocks readers of such a file for 45 s
    const SlowFile first(directory.file("gas.dbc")), second(directory.file("clash.dbc"));
    if (!first.waits() || !second.waits()) GTEST_SKIP() << "no leases of files here";
    open({file("gas.dbc"), file("clash.dbc")});
    for (int i = 0; i < 5; ++i)
        window->preferences().change([this](Preferences& p) { p.dbc = {file("clash.dbc")}; });
    QTest::qWait(300);
    const std::jthread lets([&] {
        std::this_thread::sleep_for(500ms);  // the kernel does not report when the reader blocks
        first.letGo();
    });
    const double began = steadyNow();
    window.reset();
    EXPECT_LT(steadyNow() - began, kHang);
}

}  // namespace
}  // namespace terratact
