#include "app/link/gamepad/pad_mapping.h"

#include <algorithm>
#include <cmath>

#include "core/base/named.h"

namespace terratact {
namespace {

constexpr double kPulled = 0.5, kReleased = 0.4;  // of a trigger's way

constexpr auto kPadActionNames =
    namesOf<PadAction>("stop", "second-stop", "dead-man", "drive", "feel-forward", "explore",
                       "approve", "refuse", "raise-limit", "lower-limit");
static_assert(kPadActionNames.size() == kPadActions);

bool isTrigger(PadAxis axis)
{
    return axis == PadAxis::LeftTrigger || axis == PadAxis::RightTrigger;
}

std::optional<PadControl> padControlOf(std::string_view text)
{
    for (const PadControl& control : allPadControls())
        if (textOf(control) == text) return control;
    return std::nullopt;
}

bool isStop(PadAction action)
{
    return action == PadAction::Stop || action == PadAction::SecondStop;
}

}  // namespace

std::string_view name(PadAction action)
{
    return nameIn(kPadActionNames, action);
}

std::vector<PadControl> allPadControls()
{
    std::vector<PadControl> all;
    all.reserve(kPadButtons + 2 * kPadAxes);
    for (std::size_t i = 0; i < kPadButtons; ++i) all.emplace_back(static_cast<PadButton>(i));
    for (std::size_t i = 0; i < kPadAxes; ++i) {
        const auto axis = static_cast<PadAxis>(i);
        if (isTrigger(axis)) {
            all.emplace_back(axis);
        } else {
            all.emplace_back(PadStick{axis, -1});
            all.emplace_back(PadStick{axis, +1});
        }
    }
    return all;
}

std::string textOf(const PadControl& control)
{
    if (const auto* button = std::get_if<PadButton>(&control)) return std::string(name(*button));
    if (const auto* axis = std::get_if<PadAxis>(&control)) return std::string(name(*axis));
    const auto& stick = std::get<PadStick>(control);
    return std::string(name(stick.axis)) + (stick.forward < 0 ? '-' : '+');
}

bool isSamePart(const PadControl& a, const PadControl& b)
{
    const auto* first = std::get_if<PadStick>(&a);
    const auto* second = std::get_if<PadStick>(&b);
    return first && second ? first->axis == second->axis : a == b;
}

bool suits(PadAction action, const PadControl& control)
{
    if (const auto* stick = std::get_if<PadStick>(&control))
        return action == PadAction::Drive && !isTrigger(stick->axis)
            && std::abs(stick->forward) == 1;
    if (action == PadAction::Drive) return false;
    const auto* axis = std::get_if<PadAxis>(&control);
    return !axis || isTrigger(*axis);
}

PadMapping::PadMapping()
{
    at(PadAction::Stop) = PadButton::RightShoulder;
    at(PadAction::SecondStop) = PadButton::Back;
    at(PadAction::DeadMan) = PadAxis::RightTrigger;
    at(PadAction::Drive) = PadStick{PadAxis::LeftY, -1};
    at(PadAction::FeelForward) = PadAxis::LeftTrigger;
    at(PadAction::Explore) = PadButton::X;
    at(PadAction::Approve) = PadButton::A;
    at(PadAction::Refuse) = PadButton::B;
    at(PadAction::RaiseLimit) = PadButton::Up;
    at(PadAction::LowerLimit) = PadButton::Down;
}

std::optional<PadAction> PadMapping::actionOf(const PadControl& control) const
{
    for (std::size_t i = 0; i < kPadActions; ++i)
        if (controls_[i] && isSamePart(*controls_[i], control)) return static_cast<PadAction>(i);
    return std::nullopt;
}

bool PadMapping::assign(PadAction action, const PadControl& control)
{
    if (!suits(action, control)) return false;
    const auto owner = actionOf(control);
    if (owner && *owner != action) {
        if (isStop(*owner)) return false;
        at(*owner).reset();
    }
    at(action) = control;
    return true;
}

std::string PadMapping::text() const
{
    std::string all;
    for (std::size_t i = 0; i < kPadActions; ++i) {
        if (!controls_[i]) continue;
        if (!all.empty()) all += ' ';
        all += std::string(kPadActionNames[i]) + ':' + textOf(*controls_[i]);
    }
    return all;
}

std::optional<PadMapping> PadMapping::parse(std::string_view text)
{
    PadMapping mapping;
    mapping.controls_ = {};
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        const std::size_t colon = word.find(':');
        if (colon == std::string_view::npos) return std::nullopt;
        const auto action = valueIn<PadAction>(kPadActionNames, word.substr(0, colon));
        const auto control = padControlOf(word.substr(colon + 1));
        if (!action || !control || mapping[*action] || mapping.actionOf(*control)
            || !mapping.assign(*action, *control))
            return std::nullopt;
    }
    if (!mapping[PadAction::Stop]) return std::nullopt;
    return mapping;
}

bool isOn(const PadControl& control, const GamepadState& state, bool was)
{
    if (const auto* button = std::get_if<PadButton>(&control)) return state[*button];
    if (const auto* axis = std::get_if<PadAxis>(&control))
        return state[*axis] > (was ? kReleased : kPulled);
    return false;
}

double speedOf(const PadStick& stick, const GamepadState& state, const PadSettings& settings)
{
    const double way = state[stick.axis] * stick.forward;
    const double beyond = std::min(std::abs(way), 1.0) - settings.deadZone;
    if (!(beyond > 0.0)) return 0.0;
    const double speed = beyond / (1.0 - settings.deadZone) * settings.speedLimit;
    const double steps = std::max(1.0, std::round(speed / kPadSpeedStep));
    return std::copysign(std::min(steps * kPadSpeedStep, settings.speedLimit), way);
}

}  // namespace terratact
