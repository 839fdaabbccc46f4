#pragma once

#include "app/mission/console_alarms.h"

namespace terratact {

/// Counts instead of sounding.
class CountingSounder final : public Sounder {
public:
    explicit CountingSounder(int& sounds) : sounds_(sounds) {}
    void sound() override { ++sounds_; }

private:
    int& sounds_;
};

}  // namespace terratact
