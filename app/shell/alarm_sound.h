#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <vector>

namespace terratact {

/// Makes one short sound.  GUI thread only.
class AlarmSound {
public:
    virtual ~AlarmSound() = default;
    virtual void sound() = 0;  ///< does not wait for it
    /// Why the newest that ended was not heard as it should; empty: it was, or none has ended.
    virtual QString trouble() const { return {}; }
};

/// The desktop's bell, which many desktops keep silent.
std::unique_ptr<AlarmSound> desktopBeep();

/// Two rising tones from the loudspeaker, played in a thread of its own; the desktop's bell where they cannot be.
std::unique_ptr<AlarmSound> alarmTone();

/// What alarmTone() plays: one channel, so many samples a second.
std::vector<std::int16_t> alarmSamples(unsigned rate);

}  // namespace terratact
