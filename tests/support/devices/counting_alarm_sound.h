#pragma once

#include "app/mission/console_alarms.h"

namespace terratact {

/// An alarm sound that only counts.
class CountingAlarmSound final : public AlarmSound {
public:
    explicit CountingAlarmSound(int& sounds) : sounds_(sounds) {}
    void sound() override { ++sounds_; }

private:
    int& sounds_;
};

}  // namespace terratact
