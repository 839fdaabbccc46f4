#pragma once

#include <optional>

#include "core/atem/contact_watch.h"

namespace terratact {

/// Audible cue of a contact: short ticks. Their pitch stands for the element, their rate for the force.
struct ContactTone {
    double pitch = 0.0;   ///< [Hz]
    double period = 0.0;  ///< [s] between two ticks
    bool operator==(const ContactTone&) const = default;
};

/// Pitch of element 1 (pivot); each element further to the tip is a whole tone and a half higher. The
/// tip's is 528 Hz: all lie below the alarms, which begin at 880 Hz.
inline constexpr double kPivotPitch = 222.0;

/// Forces [N] at and below which ticks are slowest, and at and above which they are fastest. The
/// period is interpolated over the logarithm of the force.
inline constexpr double kSlowestForce = 2.0, kFastestForce = 20.0;
inline constexpr double kSlowestTick = 0.8, kFastestTick = 0.12;  ///< [s]

/// Returns the tone of the strongest contact; empty: nothing touches the ground.
std::optional<ContactTone> contactTone(const FlipperContacts& state);

/// Decides when a tick sounds. While the robot drives or presses, ticks follow each other by the
/// tone's period. While it stands, only the begin of a contact and a change of its element tick.
/// `now` is any monotonic clock [s].
class ContactCue {
public:
    /// Returns the pitch [Hz] of a tick that is due now; empty: none is.
    std::optional<double> poll(const FlipperContacts& state, bool moves, double now);

private:
    std::optional<double> last_;   ///< time of the last tick of this contact [s]
    std::optional<double> pitch_;  ///< of that tick [Hz]
};

}  // namespace terratact
