#pragma once

#include "app/mission/console_alarms.h"

namespace terratact {

/// Counts instead of sounding.
class CountingAlarmSound final : public AlarmSound {
public:
    explicit CountingAlarmSound(int& sounds) : sounds_(sounds) {}
    void sound() override { ++sounds_; }

private:
    int& sounds_;
};

}  // namespace terratact
