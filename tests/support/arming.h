#pragma once

#include <QTest>
#include <functional>

#include "app/console/main_window.h"
#include "tests/support/gui.h"
#include "widgets/base/held_button.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/status_header.h"

/// How an operator arms, for every test with a console on a bus.
namespace terratact {

/// On a busy machine heartbeats may come too late and disarm the console in some go; in every one is somebody's fault.
inline constexpr int kGoes = 10;

inline ArmingPhase armingOf(const MainWindow& window)
{
    return window.link()->view().link.arming.phase;
}

/// Holds key M until the console is armed, or is no more about to be; whether it is.
inline bool confirmsArming(MainWindow& window)
{
    QTest::qWait(60);  // no operator is faster, only a server that repeats a held key
    QTest::keyPress(&window, Qt::Key_M);
    (void)gui::eventually([&] {
        return armingOf(window) == ArmingPhase::Armed || armingOf(window) == ArmingPhase::Disarmed;
    });
    QTest::keyRelease(&window, Qt::Key_M);
    QTest::qWait(60);  // likewise
    return armingOf(window) == ArmingPhase::Armed;
}

/// Both actions, `asked` between them; false where something disarmed the console there, or before the first.
inline bool armsOnce(MainWindow& window, const std::function<void()>& asked = {})
{
    const ArmingControl& arming = *window.header()->arming();
    if (!gui::eventually([&] { return arming.armButton()->isEnabled(); })) return false;
    QTest::qWait(400);  // the robot wants ten heartbeats
    QTest::keyClick(&window, Qt::Key_M);
    if (!gui::eventually([&] { return arming.confirmButton()->isVisible(); }, 2000)) return false;
    if (asked) asked();
    return confirmsArming(window);
}

/// Armed already, or in some go.
inline bool arms(MainWindow& window)
{
    for (int go = 0; go < kGoes && armingOf(window) != ArmingPhase::Armed; ++go)
        (void)armsOnce(window);
    return armingOf(window) == ArmingPhase::Armed;
}

}  // namespace terratact
