#pragma once

#include <QTest>
#include <functional>

#include "app/console/main_window.h"
#include "tests/support/gui.h"
#include "widgets/base/held_button.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/status_header.h"

/// Arming by an operator, for every test with a console on a bus.
namespace terratact {

/// [s] over a good link, after which the robot has received its ten heartbeats
inline constexpr double kHeardFor = 1.4;

inline ArmingPhase armingOf(const MainWindow& window)
{
    return window.link()->view().link.arming.phase;
}

/// Holds key M until the console is armed or the attempt has ended. Returns true if it is armed.
inline bool confirmsArming(MainWindow& window)
{
    QTest::qWait(60);  // longer than key repeat, which is no second action
    QTest::keyPress(&window, Qt::Key_M);
    (void)gui::eventually([&] {
        return armingOf(window) == ArmingPhase::Armed || armingOf(window) == ArmingPhase::Disarmed;
    });
    QTest::keyRelease(&window, Qt::Key_M);
    QTest::qWait(60);  // longer than key repeat
    return armingOf(window) == ArmingPhase::Armed;
}

/// Performs both actions, and `asked` between them. Returns false if something disarmed the console meanwhile.
inline bool armsOnce(MainWindow& window, const std::function<void()>& asked = {})
{
    const ArmingControl& arming = *window.header()->arming();
    if (!gui::eventually([&] { return arming.armButton()->isEnabled(); })) return false;
    if (!gui::eventually([&] { return window.link()->view().link.goodFor > kHeardFor; }))
        return false;
    QTest::keyClick(&window, Qt::Key_M);
    if (!gui::eventually([&] { return arming.confirmButton()->isVisible(); }, 2000)) return false;
    if (asked) asked();
    return confirmsArming(window);
}

/// Arms unless the console is armed; returns true if it is.
inline bool arms(MainWindow& window)
{
    return armingOf(window) == ArmingPhase::Armed || armsOnce(window);
}

}  // namespace terratact
