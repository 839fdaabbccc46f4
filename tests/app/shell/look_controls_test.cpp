// Tests every control of the console: name, size, keyboard access, and the reason if it is disabled.
#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QMenu>
#include <QPushButton>
#include <QStyleOptionSpinBox>
#include <set>

#include "app/console/main_window.h"
#include "app/console/pages/settings_page.h"
#include "tests/support/benches/look_bench.h"
#include "tests/support/colour_contrast.h"
#include "tests/support/gui.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

using gui::eventually;

/// Returns every widget that an operator can point at or tab to.
QList<QWidget*> controls(const MainWindow& window)
{
    QList<QWidget*> found;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        // Qt's inner widgets are announced by our own widget around them.
        const bool inner = widget->objectName().startsWith("qt_");
        const bool control =
            qobject_cast<QAbstractButton*>(widget) || (widget->focusPolicy() & Qt::TabFocus);
        if (control && !inner && widget->isVisible()) found << widget;
    }
    return found;
}

/// Returns the sizes [px] of separately pressable parts: arrows of a spin box, entries of a menu or list.
QList<QSize> partsOf(const QWidget& control)
{
    QList<QSize> parts;
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&control)) {
        QStyleOptionSpinBox option;
        option.initFrom(box);
        option.subControls = QStyle::SC_All;
        option.buttonSymbols = box->buttonSymbols();
        option.frame = box->hasFrame();
        const auto rect = [&](QStyle::SubControl part) {
            return box->style()->subControlRect(QStyle::CC_SpinBox, &option, part, box);
        };
        const QRect up = rect(QStyle::SC_SpinBoxUp), down = rect(QStyle::SC_SpinBoxDown);
        EXPECT_FALSE(up.intersects(down));
        EXPECT_FALSE(rect(QStyle::SC_SpinBoxEditField).intersects(down));
        if (box->buttonSymbols() != QAbstractSpinBox::NoButtons) parts << up.size() << down.size();
    }
    const auto* button = qobject_cast<const QPushButton*>(&control);
    if (QMenu* menu = button ? button->menu() : nullptr; menu) {
        menu->ensurePolished();
        for (QAction* action : menu->actions())
            if (!action->isSeparator()) parts << menu->actionGeometry(action).size();
    }
    if (const auto* combo = qobject_cast<const QComboBox*>(&control))
        for (int row = 0; row < combo->count(); ++row)
            parts << QSize(combo->width(), combo->view()->sizeHintForRow(row));
    return parts;
}

TEST_F(Look, everyControlHasANameAndASize)
{
    int parts = 0;
    explore();
    eachPage([&] {
        const auto all = controls(*window);
        EXPECT_GE(all.size(), 4);
        for (const QWidget* control : all) {
            const auto* button = qobject_cast<const QAbstractButton*>(control);
            const std::string what =
                std::string(control->metaObject()->className()) + " "
                + (button ? button->text() : control->objectName()).toStdString();
            EXPECT_FALSE(control->accessibleName().isEmpty()
                         && (!button || button->text().isEmpty()))
                << what;
            EXPECT_TRUE(control->width() >= 32 && control->height() >= 32)
                << what << ": " << control->width() << " × " << control->height();
            for (const QSize part : partsOf(*control)) {
                ++parts;
                EXPECT_TRUE(part.width() >= 32 && part.height() >= 32)
                    << what << ": a part of " << part.width() << " × " << part.height();
            }
            EXPECT_FALSE(button && button->toolTip().isEmpty())
                << what << " says neither what it does nor why not";
        }
    });
    EXPECT_GE(parts, 30);
}

TEST_F(Look, aDisabledButtonShowsTheReason)
{
    gui::TipsOfButtons tips;
    const auto lookEverywhere = [&] { eachPage([&] { tips.poll(*window); }); };
    lookEverywhere();
    for (const double limit : {VerdictStrip::kMinLimit, VerdictStrip::kMaxLimit}) {
        window->preferences().change([limit](Preferences& p) { p.obstacleLimit = limit; });
        tips.poll(*window);
    }
    window->preferences().change([](Preferences& p) { p.model = "/nowhere/none.ttm"; });
    explore();
    lookEverywhere();
    window->exploration().stop();  // STOP raises an alarm, too
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->releaseButton()->isVisible(); }));
    lookEverywhere();
    EXPECT_EQ(tips.silent(), std::vector<std::string>());
    for (const char* name : {"Lower the limit", "Raise the limit", "Acknowledge", "Acknowledge all",
                             "Shipped: Model", "Explore the terrain (A)"})
        EXPECT_TRUE(tips.compared().contains(name)) << name;
}

TEST_F(Look, TabReachesEverythingAndComesBack)
{
    explore();
    eachPage([&] {
        window->setFocus();
        std::set<QWidget*> reached;
        for (int i = 0; i < 300; ++i) {
            QWidget* at = QApplication::focusWidget();
            ASSERT_NE(at, nullptr);
            QTest::keyClick(at, Qt::Key_Tab);
            QWidget* next = QApplication::focusWidget();
            if (!next || reached.contains(next)) break;
            reached.insert(next);
        }
        for (QWidget* control : controls(*window)) {
            const bool reachable = control->isEnabled() && (control->focusPolicy() & Qt::TabFocus);
            EXPECT_TRUE(!reachable || reached.contains(control))
                << control->metaObject()->className() << " "
                << control->accessibleName().toStdString();
        }
    });
}

TEST_F(Look, TabFollowsTheOrderOnTheScreen)
{
    window->setFocus();
    for (QPushButton* control : {window->header()->alarmsButton(), window->header()->stopButton(),
                                 window->verdict()->lowerButton(), window->verdict()->raiseButton(),
                                 window->viewButton(), window->header()->qualityButton()}) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        EXPECT_EQ(QApplication::focusWidget(), control) << control->accessibleName().toStdString();
    }
}

/// Returns the number of pixels that differ between two pictures by a contrast of 3 : 1 (WCAG 2.2, 2.4.13).
int unlike(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < std::min(a.height(), b.height()); ++y)
        for (int x = 0; x < std::min(a.width(), b.width()); ++x)
            count += a.pixel(x, y) != b.pixel(x, y)
                  && gui::contrast(a.pixelColor(x, y), b.pixelColor(x, y)) >= 3.0;
    return count;
}

TEST_F(Look, focusIsVisibleInEveryTheme)
{
    explore();
    const auto poll = [&](ThemeName theme, std::set<QWidget*>& seen) {
        for (QWidget* control : controls(*window)) {
            if (!control->isEnabled() || !(control->focusPolicy() & Qt::TabFocus)
                || !seen.insert(control).second)
                continue;
            const std::string name = std::string(control->metaObject()->className()) + " "
                                   + control->accessibleName().toStdString();
            const auto picture = [&] {  // of the window, because the mark lies over the control
                const QPoint corner = control->mapTo(window.get(), QPoint(0, 0));
                return window->grab({corner, control->size()}).toImage();
            };
            window->setFocus();
            const QImage before = picture();
            control->setFocus(Qt::TabFocusReason);
            const QWidget* const proxy = control->focusProxy();
            EXPECT_TRUE(control->hasFocus() || (proxy && proxy->hasFocus())) << name;
            EXPECT_GE(unlike(before, picture()), 60)
                << name << ", theme " << static_cast<int>(theme);
        }
    };
    const auto pollThemes = [&] {
        for (const ThemeName theme :
             {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast}) {
            window->preferences().change([theme](Preferences& p) { p.theme = theme; });
            std::set<QWidget*> seen;
            eachPage([&] { poll(theme, seen); });
            EXPECT_GE(seen.size(), 60U) << "on all pages";
        }
    };
    pollThemes();
    window->exploration().stop();  // raises an alarm
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->releaseButton()->isVisible(); }));
    pollThemes();
}

}  // namespace
}  // namespace terratact
