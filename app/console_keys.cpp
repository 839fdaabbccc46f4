#include "app/console_keys.h"

#include <QAction>
#include <QPushButton>
#include <functional>
#include <utility>

#include "app/key_table.h"
#include "app/main_window.h"
#include "widgets/arming_control.h"
#include "widgets/atem_panel.h"
#include "widgets/drive_pad.h"
#include "widgets/held_button.h"
#include "widgets/probe_card.h"
#include "widgets/status_header.h"
#include "widgets/verdict_strip.h"

namespace terratact {
namespace {

void addHeld(KeyTable& keys, QList<QKeyCombination> of, const QString& meaning, HeldButton* button)
{
    keys.add(
        {std::move(of), meaning, [button] { button->hold(); }, [button] { button->letGoSoon(); }});
}

/// A key acts only where one sees what it acts on.
std::function<void()> ifSeen(const QPushButton* button, std::function<void()> act)
{
    return [button, act = std::move(act)] {
        if (button->isVisible() && button->isEnabled()) act();
    };
}

void addAnswerKeys(KeyTable& keys, const ProbeCard* card)
{
    const auto ifAsked = [card](std::function<void()> answer) {
        return [card, answer = std::move(answer)] {
            if (card->shown()) answer();
        };
    };
    addHeld(keys, {Qt::Key_Space},
            MainWindow::tr("approve the proposed probe, or press the button that has the focus"),
            card->approveButton());
    // A refusal harms nobody: it needs no look at what a window may cover.
    QPushButton* const refuse = card->refuseButton();
    keys.add(
        {{Qt::Key_N}, MainWindow::tr("refuse it"), ifSeen(refuse, [refuse] { refuse->click(); })});
    for (const std::size_t other : {0U, 1U, 2U})
        keys.add({{static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(other))},
                  MainWindow::tr("ask for another bin instead: the %1. offered").arg(other + 1),
                  ifAsked([card, other] { card->otherButton(other)->click(); })});
}

void addObstacleKeys(KeyTable& keys, const VerdictStrip& verdict)
{
    QPushButton *raise = verdict.raiseButton(), *lower = verdict.lowerButton();
    keys.add({{Qt::Key_PageUp},
              MainWindow::tr("raise what counts as an obstacle"),
              ifSeen(raise, [raise] { raise->click(); })});
    keys.add({{Qt::Key_PageDown}, MainWindow::tr("lower it"), ifSeen(lower, [lower] {
                  lower->click();
              })});
}

}  // namespace

void addRobotKeys(KeyTable& keys, MainWindow& window)
{
    Exploration* exploration = &window.exploration();
    ArmingControl* arming = window.header()->arming();
    keys.addGroup(MainWindow::tr("Robot"));
    keys.add({.keys = kStopKeys,
              .meaning = MainWindow::tr("STOP, in every window"),
              .pressed = [exploration] { exploration->stop(); },
              .everywhere = true});
    addHeld(keys, {Qt::Key_R}, MainWindow::tr("release STOP"), window.atemPanel()->releaseButton());
    addHeld(keys, {Qt::Key_W, Qt::Key_Up}, MainWindow::tr("drive forward"),
            window.drivePad()->forwardButton());
    addHeld(keys, {Qt::Key_S, Qt::Key_Down}, MainWindow::tr("drive back"),
            window.drivePad()->backButton());
    if (window.link())
        keys.add({{Qt::Key_M},
                  MainWindow::tr("arm the robot: press, then hold; again disarms it"),
                  [arming] { arming->pressKey(); },
                  [arming] { arming->releaseKey(); }});
}

void addExplorationKeys(KeyTable& keys, MainWindow& window, QAction& draws)
{
    Exploration* exploration = &window.exploration();
    AtemPanel* panel = window.atemPanel();
    keys.addGroup(MainWindow::tr("Exploration"));
    keys.add({{Qt::Key_A},
              MainWindow::tr("explore the terrain"),
              ifSeen(panel->requestButton(), [exploration] { exploration->request(); })});
    keys.add({{Qt::Key_O},
              MainWindow::tr("override what is doubtful about exploring"),
              ifSeen(panel->overrideButton(), [exploration] { exploration->overrideDoubts(); })});
    addAnswerKeys(keys, window.probeCard());
    keys.add({{Qt::Key_P}, MainWindow::tr("what each command needs, one after the other"), [panel] {
                  if (panel->isVisible()) panel->lookUpNext();
              }});
    addObstacleKeys(keys, *window.verdict());
    keys.add({{Qt::Key_D},
              MainWindow::tr("show some of the draws as thin lines"),
              ifSeen(window.viewButton(), [&draws] { draws.toggle(); })});
    keys.add({{Qt::Key_Escape},
              MainWindow::tr("abort the exploration, or clear its result"),
              [exploration, panel] {
                  // What runs is aborted from every page; what stands is cleared only where it is seen.
                  const bool seen = panel->abortButton()->isVisible();
                  if (!seen && !exploring(exploration->state().phase)) return;
                  if (panel->abortButton()->isEnabled()) exploration->abort();
              }});
}

}  // namespace terratact
