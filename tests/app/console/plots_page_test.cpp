// Tests the plots of the running console: live values, keys and names, sets, the dock below other pages.
#include "app/pages/plots_page.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>

#include "tests/support/benches/console_bench.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/signals/plot_values.h"
#include "widgets/signals/signal_list.h"
#include "widgets/signals/time_plots.h"

namespace terratact {
namespace {

using gui::eventually;

struct PlotsOfConsole : Console {
    PlotsPanel& panel() const { return *window->plotsPage()->panel(); }
    void press(int key, Qt::KeyboardModifiers with = {})
    {
        QTest::keyClick(window.get(), static_cast<Qt::Key>(key), with);
    }
    bool hasValues(int row) const
    {
        return eventually([&] {
            return panel().values()->rows() > row
                && panel().values()->text(row, PlotValues::Count) != "0";
        });
    }
};

TEST_F(PlotsOfConsole, showTelemetryAtOnce)
{
    ScriptedSource* script = openScripted();
    Measurement m;
    m.pitch = 0.25;
    script->setMeasurement(m);
    press(kPlotsKey);
    ASSERT_TRUE(panel().isVisible());
    EXPECT_EQ(panel().plots()->rows(), 4) << "the usual plots";
    ASSERT_TRUE(hasValues(0));
    EXPECT_TRUE(
        eventually([&] { return panel().values()->text(0, PlotValues::Cursor) == "14.324"; }));
    EXPECT_EQ(panel().values()->text(0, PlotValues::Unit), QString::fromUtf8("°")) << "not radians";
    EXPECT_TRUE(panel().liveButton()->isChecked());
    panel().removeButton()->click();
    EXPECT_EQ(panel().plots()->rows(), 3);
}

TEST_F(PlotsOfConsole, aSignalIsAddedByKeysAndByDrop)
{
    openScripted();
    press(kPlotsKey);
    SignalList& list = *panel().list();
    list.filter()->setText("rear flipper left");
    list.choose("telemetry:rear_left");
    QTest::keyClick(list.list(), Qt::Key_Return);
    EXPECT_EQ(panel().plots()->rows(), 5);
    EXPECT_TRUE(list.list()->currentItem()->text().startsWith("✓"));
    const QPoint onFirst = panel().plots()->row(0)->canvas()->mapToGlobal(QPoint(20, 20));
    emit list.dropped("telemetry:turned", onFirst);
    EXPECT_EQ(panel().state().rows()[0].size(), 3U);
    emit list.dropped("telemetry:travelled", QPoint(-5, -5));
    EXPECT_EQ(panel().state().keys().size(), 10U) << "beside the plots: nothing";
    for (const char* key : {"telemetry:force2", "telemetry:force3", "telemetry:force5"})
        emit list.wanted(key);
    EXPECT_EQ(panel().plots()->rows(), 6);
    EXPECT_TRUE(panel().note()->text().contains("No room")) << panel().note()->text().toStdString();
}

TEST_F(PlotsOfConsole, setsAreSavedAndUsedAgain)
{
    openScripted();
    press(kPlotsKey);
    panel().saveButton()->click();
    EXPECT_TRUE(panel().note()->text().contains("name"));
    panel().sets()->setEditText("mine");
    panel().saveButton()->click();
    EXPECT_EQ(panel().sets()->count(), 1);
    const PlotRows saved = panel().state().rows();
    panel().removeButton()->click();
    EXPECT_NE(panel().state().rows(), saved);
    emit panel().sets()->textActivated("mine");
    EXPECT_EQ(panel().state().rows(), saved);
}

TEST_F(PlotsOfConsole, theDockStaysBelowOtherPages)
{
    openScripted();
    window->setRoom({1920, 1200});
    window->resize(1920, 1200);
    press(Qt::Key_P, Qt::ControlModifier);
    EXPECT_TRUE(eventually([&] { return window->isDockShown() && panel().isVisible(); }));
    EXPECT_TRUE(panel().plots()->isVisible());
    EXPECT_FALSE(panel().list()->isVisible());
    EXPECT_TRUE(window->terrain()->isVisible());
    ASSERT_TRUE(hasValues(0));
    press(kPlotsKey);
    EXPECT_FALSE(window->isDockShown());
    EXPECT_TRUE(panel().list()->isVisible());
    press(Qt::Key_F2);
    EXPECT_TRUE(eventually([&] { return window->isDockShown(); }));
    (void)eventually([&] { return gui::cramped(*window).empty(); });
    EXPECT_EQ(gui::cramped(*window), std::vector<std::string>());
    window->resize(1920, 720);
    EXPECT_TRUE(eventually([&] { return !window->isDockShown(); })) << "no room to spare";
    (void)eventually([&] { return gui::cramped(*window).empty(); });
    EXPECT_EQ(gui::cramped(*window), std::vector<std::string>());
    window->resize(1920, 1200);
    EXPECT_TRUE(eventually([&] { return window->isDockShown(); }));
    press(Qt::Key_P, Qt::ControlModifier);
    EXPECT_FALSE(window->isDockShown());
}

TEST_F(PlotsOfConsole, everyControlHasNameFocusAndSize)
{
    openScripted();
    window->setRoom({1200, 680});
    window->resize(1200, 680);
    press(kPlotsKey);
    QCoreApplication::processEvents();
    int controls = 0;
    for (const QWidget* widget : panel().findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->objectName().startsWith("qt_")) continue;
        const bool isButton = qobject_cast<const QAbstractButton*>(widget) != nullptr;
        if (isButton && !qobject_cast<const QPushButton*>(widget))
            continue;  // of a field or a table
        if (!isButton && !(widget->focusPolicy() & Qt::TabFocus)) continue;
        ++controls;
        EXPECT_TRUE(widget->focusPolicy() & Qt::TabFocus) << widget->accessibleName().toStdString();
        EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->metaObject()->className();
        EXPECT_GE(std::min(widget->width(), widget->height()), 30)
            << widget->accessibleName().toStdString();
    }
    EXPECT_GE(controls, 22);
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
}

TEST_F(PlotsOfConsole, stopWorksWhileASignalIsDragged)
{
    openScripted();
    press(kPlotsKey);
    QWidget* const area = panel().list()->list()->viewport();
    const QPoint from(20, 10);
    QTest::mousePress(area, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, from + QPoint(400, 60),
                     area->mapToGlobal(from + QPoint(400, 60)), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(area, &move);
    press(Qt::Key_F12);
    EXPECT_EQ(stopsPressed(), 1);
    QTest::mouseRelease(area, Qt::LeftButton, {}, from + QPoint(400, 60));
}

/// Saves pictures if TERRATACT_PICTURES names a folder.
TEST_F(PlotsOfConsole, fitInEveryThemeAndInASmallWindow)
{
    open(fastRobot(robot, 2.0));
    const auto save = [this](const char* name) {
        const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
        if (folder.isEmpty()) return;
        QTest::qWait(500);  // the plots take the colours of the theme
        window->grab().save(QStringLiteral("%1/plots_%2.png").arg(folder, name));
    };
    proposeByKeyboard();
    press(kPlotsKey);
    ASSERT_TRUE(hasValues(0));
    if (qEnvironmentVariableIsSet("TERRATACT_PICTURES")) QTest::qWait(25'000);  // lines to look at
    struct Look {
        ThemeName theme;
        QSize size;
        const char* name;
    };
    for (const Look& look : {Look{ThemeName::Day, {1280, 720}, "day"},
                             Look{ThemeName::NightRed, {1440, 900}, "night_red"},
                             Look{ThemeName::HighContrast, {1024, 600}, "high_contrast"}}) {
        window->setRoom(look.size);
        window->preferences().change([&](Preferences& p) { p.theme = look.theme; });
        window->resize(look.size);
        EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>()) << look.name;
        EXPECT_GE(panel().plots()->row(0)->canvas()->height(), 40) << look.name;
        save(look.name);
    }
    window->preferences().change([](Preferences& p) { p.theme = ThemeName::Day; });
    window->setRoom({1920, 1080});
    window->resize(1920, 1080);
    press(Qt::Key_P, Qt::ControlModifier);
    press(Qt::Key_F2);
    EXPECT_TRUE(eventually([&] { return window->isDockShown(); }));
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    save("dock");
}

}  // namespace
}  // namespace terratact
