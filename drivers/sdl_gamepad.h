#pragma once

#include <memory>

#include "drivers/gamepad.h"

namespace terratact {

/// Returns the gamepads that SDL 2 knows, in its standard layout. SDL starts in the first poll,
/// without video, and takes no signals of the program. It reads the kernel's input devices, also
/// while another window is active. If it cannot start, poll() says why and reports no gamepad. A
/// joystick without a layout is not used, and poll() names it.
std::unique_ptr<Gamepad> openSdlGamepad();

}  // namespace terratact
