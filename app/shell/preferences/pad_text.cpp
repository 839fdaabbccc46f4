#include "app/shell/preferences/pad_text.h"

#include <QCoreApplication>

namespace terratact {
namespace {

struct PadText {
    Q_DECLARE_TR_FUNCTIONS(PadText)
};

QString buttonName(PadButton button)
{
    switch (button) {
    case PadButton::A: return PadText::tr("A (lower)");
    case PadButton::B: return PadText::tr("B (right)");
    case PadButton::X: return PadText::tr("X (left)");
    case PadButton::Y: return PadText::tr("Y (upper)");
    case PadButton::Back: return PadText::tr("Back");
    case PadButton::Guide: return PadText::tr("Guide");
    case PadButton::Start: return PadText::tr("Start");
    case PadButton::LeftStick: return PadText::tr("left stick, pressed");
    case PadButton::RightStick: return PadText::tr("right stick, pressed");
    case PadButton::LeftShoulder: return PadText::tr("left shoulder");
    case PadButton::RightShoulder: return PadText::tr("right shoulder");
    case PadButton::Up: return PadText::tr("cross, up");
    case PadButton::Down: return PadText::tr("cross, down");
    case PadButton::Left: return PadText::tr("cross, left");
    case PadButton::Right: return PadText::tr("cross, right");
    }
    return {};
}

}  // namespace

QString actionName(PadAction action)
{
    switch (action) {
    case PadAction::Stop: return PadText::tr("STOP");
    case PadAction::SecondStop: return PadText::tr("STOP, second control");
    case PadAction::DeadMan: return PadText::tr("dead-man control (hold)");
    case PadAction::Drive: return PadText::tr("drive");
    case PadAction::FeelForward: return PadText::tr("feel forward (hold)");
    case PadAction::Explore: return PadText::tr("explore");
    case PadAction::Approve: return PadText::tr("approve the probe (hold)");
    case PadAction::Refuse: return PadText::tr("refuse the probe");
    case PadAction::RaiseLimit: return PadText::tr("raise the step limit");
    case PadAction::LowerLimit: return PadText::tr("lower the step limit");
    }
    return {};
}

QString shortName(PadAction action)
{
    switch (action) {
    case PadAction::Stop:
    case PadAction::SecondStop: return PadText::tr("STOP");
    case PadAction::DeadMan: return PadText::tr("dead-man");
    case PadAction::Drive: return PadText::tr("drive");
    case PadAction::FeelForward: return PadText::tr("feel forward");
    case PadAction::Explore: return PadText::tr("explore");
    case PadAction::Approve: return PadText::tr("approve");
    case PadAction::Refuse: return PadText::tr("refuse");
    case PadAction::RaiseLimit: return PadText::tr("limit up");
    case PadAction::LowerLimit: return PadText::tr("limit down");
    }
    return {};
}

QString axisName(PadAxis axis)
{
    switch (axis) {
    case PadAxis::LeftX: return PadText::tr("left stick, sideways");
    case PadAxis::LeftY: return PadText::tr("left stick, up and down");
    case PadAxis::RightX: return PadText::tr("right stick, sideways");
    case PadAxis::RightY: return PadText::tr("right stick, up and down");
    case PadAxis::LeftTrigger: return PadText::tr("left trigger");
    case PadAxis::RightTrigger: return PadText::tr("right trigger");
    }
    return {};
}

QString controlName(const PadControl& control)
{
    if (const auto* button = std::get_if<PadButton>(&control)) return buttonName(*button);
    if (const auto* axis = std::get_if<PadAxis>(&control)) return axisName(*axis);
    return axisName(std::get<PadStick>(control).axis);
}

}  // namespace terratact
