#include "drivers/gamepad.h"

namespace terratact {
namespace {

constexpr std::array<std::string_view, kPadAxes> kPadAxisNames{
    "leftx", "lefty", "rightx", "righty", "lefttrigger", "righttrigger"};
constexpr std::array<std::string_view, kPadButtons> kPadButtonNames{"a",
                                                                    "b",
                                                                    "x",
                                                                    "y",
                                                                    "back",
                                                                    "guide",
                                                                    "start",
                                                                    "leftstick",
                                                                    "rightstick",
                                                                    "leftshoulder",
                                                                    "rightshoulder",
                                                                    "dpup",
                                                                    "dpdown",
                                                                    "dpleft",
                                                                    "dpright"};

}  // namespace

std::string_view name(PadAxis axis)
{
    return kPadAxisNames.at(static_cast<std::size_t>(axis));
}

std::string_view name(PadButton button)
{
    return kPadButtonNames.at(static_cast<std::size_t>(button));
}

}  // namespace terratact
