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

/// Attempts to arm. On a busy machine late heartbeats may disarm the console in one attempt; failing in all is an
/// error.
inline constexpr int kGoes = 10;

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
    QTest::qWait(400);  // waits for the robot's ten heartbeats
    QTest::keyClick(&window, Qt::Key_M);
    if (!gui::eventually([&] { return arming.confirmButton()->isVisible(); }, 2000)) return false;
    if (asked) asked();
    return confirmsArming(window);
}

/// Arms in one of several attempts; returns true if the console is armed.
inline bool arms(MainWindow& window)
{
    for (int go = 0; go < kGoes && armingOf(window) != ArmingPhase::Armed; ++go)
        (void)armsOnce(window);
    return armingOf(window) == ArmingPhase::Armed;
}

}  // namespace terratact
