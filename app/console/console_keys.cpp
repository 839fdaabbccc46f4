#include "app/console/console_keys.h"

#include <QAction>
#include <QPushButton>
#include <functional>
#include <utility>

#include "app/console/main_window.h"
#include "app/console/past/history_control.h"
#include "app/pages/side_keys.h"
#include "app/shell/key_table.h"
#include "widgets/base/held_button.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

void addHeld(KeyTable& keys, QList<QKeyCombination> of, const QString& meaning, HeldButton* button)
{
    keys.add({std::move(of), meaning, [button] { button->hold(); },
              [button] { button->letGoSoon(); }, [button] { button->holdOn(); }});
}

using WhyNot = std::optional<Message> (Exploration::*)() const;

constexpr SourceText kOnTerrainPage =
    TR_NOOP("terratact::MainWindow", "it is done on the page Terrain (F2)");

/// Explores as the button does, or shows why not.
void explore(const QPushButton& button, MainWindow& window)
{
    Exploration& exploration = window.exploration();
    if (button.isVisible() && button.isEnabled()) return exploration.request();
    window.showWhyNot({TR_NOOP("terratact::MainWindow", "not explored: %1"),
                       exploration.whyNotExploring().value_or(kOnTerrainPage)});
}

/// Adds a hold-to-run key that moves the robot.
void addDriveKey(KeyTable& keys, QList<QKeyCombination> of, const QString& meaning,
                 HeldButton* button, MainWindow& window,
                 WhyNot whyNot = &Exploration::whyNotDriving)
{
    keys.add({std::move(of), meaning,
              [button, &window, whyNot] { holdToMove(*button, window, whyNot); },
              [button] { button->letGoSoon(); }, [button] { button->holdOn(); }});
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
    // Refusing is always safe, so it is allowed even if a window covers the card.
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
    keys.add({{Qt::Key_PageUp}, MainWindow::tr("raise the step limit"), ifSeen(raise, [raise] {
                  raise->click();
              })});
    keys.add({{Qt::Key_PageDown}, MainWindow::tr("lower it"), ifSeen(lower, [lower] {
                  lower->click();
              })});
}

}  // namespace

void holdToMove(HeldButton& button, MainWindow& window, WhyNot whyNot)
{
    if (button.isEnabled() && button.isVisible()) return button.hold();
    window.showWhyNot({TR_NOOP("terratact::MainWindow", "not driven: %1"),
                       (window.exploration().*whyNot)().value_or(kOnTerrainPage)});
}

std::function<void()> ifSeen(const QWidget* control, std::function<void()> act)
{
    return [control, act = std::move(act)] {
        if (control->isVisible() && control->isEnabled()) act();
    };
}

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
    addDriveKey(keys, {Qt::Key_W, Qt::Key_Up}, MainWindow::tr("drive forward"),
                window.drivePad()->forwardButton(), window);
    addDriveKey(keys, {Qt::Key_S, Qt::Key_Down}, MainWindow::tr("drive back"),
                window.drivePad()->backButton(), window);
    addDriveKey(keys, {Qt::Key_F},
                MainWindow::tr("feel forward: press, estimate and advance while CLEAR"),
                window.drivePad()->feelButton(), window, &Exploration::whyNotFeelingForward);
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
    keys.add({{Qt::Key_A}, MainWindow::tr("explore the terrain"), [panel, &window] {
                  explore(*panel->requestButton(), window);
              }});
    keys.add({{Qt::Key_O},
              MainWindow::tr("explore in spite of a doubtful requirement (override)"),
              ifSeen(panel->overrideButton(), [exploration] { exploration->overrideWarnings(); })});
    addAnswerKeys(keys, window.probeCard());
    keys.add({{Qt::Key_B},
              MainWindow::tr("ask for a probe: of the selected bin, else of the best one"),
              ifSeen(window.viewButton(), [&window] { window.askProbe(); })});
    keys.add(
        {{Qt::Key_P}, MainWindow::tr("requirements of each command, one after the other"), [panel] {
             if (panel->isVisible()) panel->lookUpNext();
         }});
    addObstacleKeys(keys, *window.verdict());
    keys.add({{Qt::Key_D},
              MainWindow::tr("show some draws as thin lines"),
              ifSeen(window.viewButton(), [&draws] { draws.toggle(); })});
    addSideKeys(keys, *window.terrain(), true);
    window.addPictureKeys(keys);
    keys.add({{Qt::Key_Escape},
              MainWindow::tr("abort the exploration; its result stays"),
              [exploration] {
                  // Works on every page. A following console has nothing to abort.
                  if (exploring(exploration->state().phase) && !exploration->following())
                      exploration->abort();
              }});
    keys.add({{Qt::Key_Delete}, MainWindow::tr("forget the estimate"), ifSeen(panel, [exploration] {
                  exploration->forgetResult();
              })});
    keys.add({{QKeyCombination(Qt::CTRL, Qt::Key_Z)},
              MainWindow::tr("restore the hidden estimate"),
              ifSeen(panel, [exploration] { exploration->restoreResult(); })});
    keys.add({{QKeyCombination(Qt::CTRL, Qt::Key_H)},
              MainWindow::tr("list the estimates of this run"),
              [&window] { window.history().open(); }});
    keys.add({{Qt::Key_Backspace},
              MainWindow::tr("show the present estimate in the picture again"),
              [&window] { window.history().showPresent(); }});
}

}  // namespace terratact
