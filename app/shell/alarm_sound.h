#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <vector>

namespace terratact {

/// Plays one short sound. GUI thread only.
class AlarmSound {
public:
    virtual ~AlarmSound() = default;
    virtual void sound() = 0;  ///< returns at once
    /// Returns why the last finished sound failed; empty: it played, or none has finished.
    virtual QString trouble() const { return {}; }
};

/// Returns the desktop's bell, which many desktops mute.
std::unique_ptr<AlarmSound> desktopBeep();

/// Returns a player of two rising tones on the loudspeaker, in its own thread. It falls back to the desktop's bell.
std::unique_ptr<AlarmSound> alarmTone();

/// Returns the samples of alarmTone(): one channel at `rate` samples per second.
std::vector<std::int16_t> alarmSamples(unsigned rate);

}  // namespace terratact
