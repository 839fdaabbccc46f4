#include "drivers/sdl_gamepad.h"

#define SDL_MAIN_HANDLED
#include <SDL.h>

#include <algorithm>
#include <array>
#include <thread>
#include <utility>

namespace terratact {
namespace {

constexpr double kFullAxis = 32767.0;
constexpr int kBluetooth = 5;  // BUS_BLUETOOTH of linux/input.h: the first two bytes of SDL's GUID

constexpr std::array kSdlAxes{SDL_CONTROLLER_AXIS_LEFTX,       SDL_CONTROLLER_AXIS_LEFTY,
                              SDL_CONTROLLER_AXIS_RIGHTX,      SDL_CONTROLLER_AXIS_RIGHTY,
                              SDL_CONTROLLER_AXIS_TRIGGERLEFT, SDL_CONTROLLER_AXIS_TRIGGERRIGHT};
constexpr std::array kSdlButtons{SDL_CONTROLLER_BUTTON_A,
                                 SDL_CONTROLLER_BUTTON_B,
                                 SDL_CONTROLLER_BUTTON_X,
                                 SDL_CONTROLLER_BUTTON_Y,
                                 SDL_CONTROLLER_BUTTON_BACK,
                                 SDL_CONTROLLER_BUTTON_GUIDE,
                                 SDL_CONTROLLER_BUTTON_START,
                                 SDL_CONTROLLER_BUTTON_LEFTSTICK,
                                 SDL_CONTROLLER_BUTTON_RIGHTSTICK,
                                 SDL_CONTROLLER_BUTTON_LEFTSHOULDER,
                                 SDL_CONTROLLER_BUTTON_RIGHTSHOULDER,
                                 SDL_CONTROLLER_BUTTON_DPAD_UP,
                                 SDL_CONTROLLER_BUTTON_DPAD_DOWN,
                                 SDL_CONTROLLER_BUTTON_DPAD_LEFT,
                                 SDL_CONTROLLER_BUTTON_DPAD_RIGHT};
static_assert(kSdlAxes.size() == kPadAxes && kSdlButtons.size() == kPadButtons);

std::string textOf(const char* text)
{
    return text ? text : "";
}

class SdlGamepad final : public Gamepad {
public:
    SdlGamepad() = default;
    SdlGamepad(const SdlGamepad&) = delete;
    SdlGamepad& operator=(const SdlGamepad&) = delete;
    ~SdlGamepad() override
    {
        close();
        if (runs_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    }

    GamepadState poll(std::chrono::milliseconds pause) override
    {
        if (!tried_) start();
        std::this_thread::sleep_for(pause);
        GamepadState state;
        if (!runs_) {
            state.trouble = trouble_;
            return state;
        }
        SDL_GameControllerUpdate();
        SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);  // nobody reads SDL's queue
        if (pad_ && SDL_GameControllerGetAttached(pad_) != SDL_TRUE) close();
        if (!pad_) openFirst(state);
        if (pad_) read(state);
        return state;
    }

private:
    void start()
    {
        tried_ = true;
        SDL_SetMainReady();
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
        // The kernel's drivers report every pad and its loss. SDL's own would need the raw USB devices.
        SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI, "0");
        // A is the lower button on every pad, whatever its label.
        SDL_SetHint(SDL_HINT_GAMECONTROLLER_USE_BUTTON_LABELS, "0");
        runs_ = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
        if (!runs_)
            trouble_ =
                Message(TR_NOOP("Gamepad", "no gamepad is read, because SDL cannot start: %1"),
                        textOf(SDL_GetError()));
    }

    void openFirst(GamepadState& state)
    {
        std::string unknown;
        const int count = SDL_NumJoysticks();
        for (int i = 0; i < count && !pad_; ++i) {
            if (SDL_IsGameController(i) == SDL_TRUE)
                pad_ = SDL_GameControllerOpen(i);
            else
                unknown = textOf(SDL_JoystickNameForIndex(i));
        }
        if (pad_)
            ++connections_;
        else if (!unknown.empty())
            state.trouble = Message(
                TR_NOOP("Gamepad", "“%1” is not used, because SDL knows no layout of it: set "
                                   "SDL_GAMECONTROLLERCONFIG, or use another gamepad"),
                unknown);
    }

    void read(GamepadState& state) const
    {
        state.connection = connections_;
        state.name = textOf(SDL_GameControllerName(pad_));
        const SDL_JoystickGUID guid = SDL_JoystickGetGUID(SDL_GameControllerGetJoystick(pad_));
        state.radio = guid.data[0] == kBluetooth && guid.data[1] == 0;
        for (std::size_t i = 0; i < kPadAxes; ++i)
            state.axes[i] =
                std::clamp(SDL_GameControllerGetAxis(pad_, kSdlAxes[i]) / kFullAxis, -1.0, 1.0);
        for (std::size_t i = 0; i < kPadButtons; ++i)
            state.buttons[i] = SDL_GameControllerGetButton(pad_, kSdlButtons[i]) != 0;
    }

    void close()
    {
        if (pad_) SDL_GameControllerClose(std::exchange(pad_, nullptr));
    }

    bool tried_ = false, runs_ = false;
    Message trouble_;
    SDL_GameController* pad_ = nullptr;
    std::uint32_t connections_ = 0;
};

}  // namespace

std::unique_ptr<Gamepad> openSdlGamepad()
{
    return std::make_unique<SdlGamepad>();
}

}  // namespace terratact
