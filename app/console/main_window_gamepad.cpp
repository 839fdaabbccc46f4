// The gamepad at the console's window.
#include <QApplication>

#include "app/console/gamepad_control.h"
#include "app/console/main_window.h"
#include "app/console/pages/gamepad_page.h"

namespace terratact {

void MainWindow::addGamepad(std::unique_ptr<Gamepad> gamepad)
{
    if (!gamepad) return;
    gamepad_ = std::make_unique<GamepadControl>(std::move(gamepad), *source_, *this, inputClock_);
    connect(gamepad_.get(), &GamepadControl::happened, this, &MainWindow::log);
}

/// The gamepad acts where keys would: in the active window without an open menu, but not on its own page.
void MainWindow::pollGamepad(double now, bool frozen)
{
    if (!gamepad_) return;
    if (frozen) gamepad_->release();
    const bool mayAct = isActiveWindow() && !QApplication::activePopupWidget()
                     && !QApplication::activeModalWidget() && !gamepadPage_->isVisible();
    gamepad_->poll(now, mayAct);
    if (gamepadPage_->isVisible()) gamepadPage_->poll(gamepad_->state());
}

}  // namespace terratact
