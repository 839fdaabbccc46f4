#include "app/mission/text/robot_text.h"

#include <QCoreApplication>

namespace terratact {
namespace {

struct RobotWords {
    Q_DECLARE_TR_FUNCTIONS(RobotWords)
};

}  // namespace

Tone toneOf(RobotActivity activity)
{
    switch (activity) {
    case RobotActivity::Halted: return Tone::Plain;
    case RobotActivity::Driving:
    case RobotActivity::Pressing:
    case RobotActivity::Probing: return Tone::Accent;
    case RobotActivity::Pressed: return Tone::Good;
    case RobotActivity::Stopped: return Tone::Bad;
    }
    return Tone::Plain;
}

QString glance(RobotActivity activity)
{
    switch (activity) {
    case RobotActivity::Halted: return RobotWords::tr("halted");
    case RobotActivity::Driving: return RobotWords::tr("driving");
    case RobotActivity::Pressing: return RobotWords::tr("pressing down");
    case RobotActivity::Pressed: return RobotWords::tr("flippers pressed");
    case RobotActivity::Probing: return RobotWords::tr("arm is probing");
    case RobotActivity::Stopped: return RobotWords::tr("stopped");
    }
    return {};
}

}  // namespace terratact
