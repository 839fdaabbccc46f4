#pragma once

#define SDL_MAIN_HANDLED
#include <SDL.h>

#include <cstdint>
#include <stdexcept>
#include <string>

#include "drivers/gamepad.h"

namespace terratact {

/// A virtual joystick at SDL's own interface, which programs cannot distinguish from a real one. It is attached while
/// the object lives; the test moves its controls.
class VirtualPad {
public:
    enum class Kind : std::uint8_t { Gamepad, UnknownJoystick };
    static constexpr int kUsb = 3, kBluetooth = 5;

    explicit VirtualPad(std::string name = "Test pad", Kind kind = Kind::Gamepad)
        : name_(std::move(name))
    {
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI, "0");
        SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
        SDL_VirtualJoystickDesc description{};
        description.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
        description.type = kind == Kind::Gamepad ? SDL_JOYSTICK_TYPE_GAMECONTROLLER
                                                 : SDL_JOYSTICK_TYPE_FLIGHT_STICK;
        description.naxes = kPadAxes;
        description.nbuttons = kPadButtons;
        description.axis_mask = (1U << kPadAxes) - 1U;
        description.button_mask = (1U << kPadButtons) - 1U;
        description.name = name_.c_str();
        const int index = SDL_JoystickAttachVirtualEx(&description);
        joystick_ = index < 0 ? nullptr : SDL_JoystickOpen(index);
        if (!joystick_) throw std::runtime_error(SDL_GetError());
        set(PadAxis::LeftTrigger, 0.0);
        set(PadAxis::RightTrigger, 0.0);
    }
    VirtualPad(const VirtualPad&) = delete;
    VirtualPad& operator=(const VirtualPad&) = delete;
    ~VirtualPad()
    {
        detach();
        SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    }

    /// Unplugs it, whatever is held.
    void detach()
    {
        if (!joystick_) return;
        const SDL_JoystickID id = SDL_JoystickInstanceID(joystick_);
        for (int i = SDL_NumJoysticks() - 1; i >= 0; --i)
            if (SDL_JoystickGetDeviceInstanceID(i) == id) SDL_JoystickDetachVirtual(i);
        SDL_JoystickClose(joystick_);
        joystick_ = nullptr;
    }
    /// Sticks −1 … 1, triggers 0 … 1.
    void set(PadAxis axis, double value)
    {
        const bool isTrigger = axis == PadAxis::LeftTrigger || axis == PadAxis::RightTrigger;
        const double way = isTrigger ? 2.0 * value - 1.0 : value;
        SDL_JoystickSetVirtualAxis(joystick_, static_cast<int>(axis),
                                   static_cast<Sint16>(way * 32767.0));
    }
    void set(PadButton button, bool pressed)
    {
        SDL_JoystickSetVirtualButton(joystick_, static_cast<int>(button), pressed ? 1 : 0);
    }

private:
    std::string name_;
    SDL_Joystick* joystick_ = nullptr;
};

}  // namespace terratact
