#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <vector>

namespace terratact {

/// Plays one short sound at a time. GUI thread only.
class AlarmSound {
public:
    virtual ~AlarmSound() = default;
    virtual void sound() = 0;  ///< the alarm; returns at once
    /// Plays a tick of a contact, which is short, low and soft; returns at once. It is left out while the alarm sounds
    /// or is due. pitch: [Hz]; level: 0 … 1. A player that cannot change its pitch plays none.
    virtual void tick(double /*pitch*/, double /*level*/) {}
    /// Returns why the last finished sound failed; empty: it played, or none has finished.
    virtual QString trouble() const { return {}; }
};

/// Returns the desktop's bell, which many desktops mute.
std::unique_ptr<AlarmSound> desktopBeep();

/// Returns a player of two rising tones on the loudspeaker, in its own thread. It falls back to the desktop's bell.
std::unique_ptr<AlarmSound> alarmTone();

/// Returns the samples of a tick: 60 ms that fade away, with an octave above the pitch. At level 1 it has less than
/// half of the alarm's amplitude.
std::vector<std::int16_t> contactSamples(unsigned rate, double pitch, double level);

/// Returns the samples of alarmTone(): one channel at `rate` samples per second.
std::vector<std::int16_t> alarmSamples(unsigned rate);

}  // namespace terratact
