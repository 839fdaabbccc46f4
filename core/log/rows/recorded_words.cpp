#include "core/log/rows/recorded_words.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace terratact {
namespace {

struct Recorded {
    std::string_view words, name;
};

constexpr std::array kPhases{Recorded{"ready", "idle"},
                             Recorded{"halting the robot", "halting"},
                             Recorded{"pressing the front flippers down", "pressing"},
                             Recorded{"estimating the terrain", "estimating"},
                             Recorded{"arm probe proposed", "proposing-probe"},
                             Recorded{"arm is probing", "probing"},
                             Recorded{"estimating again with the arm's height", "estimating-again"},
                             Recorded{"estimate stands", "presenting"},
                             Recorded{"STOPPED", "stopped"},
                             Recorded{"exploration failed", "failed"}};

constexpr std::array kFailures{
    Recorded{"no failure", "none"},
    Recorded{"the robot did not halt in time", "halt-timeout"},
    Recorded{"the flippers found nothing to press against in time", "press-timeout"},
    Recorded{"the estimate took too long", "estimate-timeout"},
    Recorded{"the estimate could not be computed", "estimate-error"},
    Recorded{"the arm did not finish in time", "probe-timeout"},
    Recorded{"the robot refused the probe", "probe-refused"},
    Recorded{"the robot refused to press", "press-refused"},
    Recorded{"the link to the robot was lost", "link-lost"},
    Recorded{"the robot moved, so what it felt no longer holds", "pose-changed"},
    Recorded{"the approval was of another scene, settings or model", "approval-void"},
    Recorded{"the robot is not armed", "disarmed"}};

constexpr std::array kArmingPhases{
    Recorded{"disarmed", "disarmed"}, Recorded{"confirm to arm", "confirming"},
    Recorded{"waiting for the robot to arm", "requested"}, Recorded{"armed", "armed"}};

constexpr std::array kCauses{
    Recorded{"not armed yet", "none"},
    Recorded{"disarmed by the operator", "operator"},
    Recorded{"STOP is latched", "stop"},
    Recorded{"window or panel does not answer", "operator-absent"},
    Recorded{"somebody else sends this console's frames", "foreign-sender"},
    Recorded{"the link is not good", "link-not-good"},
    Recorded{"the robot is armed, but not by this console", "already-armed"},
    Recorded{"not confirmed in time", "confirm-timeout"},
    Recorded{"the robot did not arm in time", "request-timeout"},
    Recorded{"the robot has disarmed", "robot-disarmed"},
    Recorded{"the robot has begun anew", "epoch-changed"}};

void replace(std::string& words, std::span<const Recorded> table)
{
    const auto found = std::ranges::find(table, words, &Recorded::words);
    if (found != table.end()) words = found->name;
}

}  // namespace

EventRow withNames(EventRow event)
{
    if (event.kind == EventKind::Phase) {
        replace(event.subject, kPhases);
        replace(event.text, kFailures);
    }
    if (event.kind == EventKind::Arming) {
        replace(event.subject, kArmingPhases);
        replace(event.text, kCauses);
    }
    return event;
}

}  // namespace terratact
