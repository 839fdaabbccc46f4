#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace terratact {

/// A place where the clock of a recording was set.
struct ClockStep {
    std::int64_t time = 0;    ///< [ns] on the even clock
    double back = 0.0;        ///< [s]; negative: set forward
    std::uint64_t shift = 0;  ///< what is added to later times [ns], modulo 2^64
};

/// Returns how far the clock was set back between two successive times [s]; negative: forward. Empty
/// unless it is more than 1 s back, or more than ten years forward.
std::optional<double> clockStepBetween(std::int64_t before, std::int64_t time);

/// Makes the times of series even that were recorded while the clock was set. All series share
/// their steps, so that their values stay together.
class EvenClock {
public:
    static constexpr std::size_t kMaxSteps = 16;  ///< more falls: the values are not in order

    /// Shifts the times of samples, which are in the file's order. Leaves them where there are more
    /// than kMaxSteps steps.
    template <class Samples>
    void make(Samples& samples)
    {
        if (steps(samples) > kMaxSteps) {
            isDisordered_ = true;
            return;
        }
        Follower follower{*this};
        for (auto& sample : samples) sample.time = follower.add(sample.time);
    }

    const std::vector<ClockStep>& steps() const { return steps_; }
    bool isDisordered() const { return isDisordered_; }

    /// Follows the times of one series.
    struct Follower {
        EvenClock& clock;
        std::optional<std::int64_t> before{};
        std::int64_t interval = 1;
        std::uint64_t shift = 0;
        std::size_t steps = 0;

        std::int64_t add(std::int64_t time);
    };

private:
    template <class Samples>
    static std::size_t steps(const Samples& samples)
    {
        std::size_t count = 0;
        for (std::size_t i = 1; i < samples.size(); ++i)
            count += clockStepBetween(samples[i - 1].time, samples[i].time) ? 1 : 0;
        return count;
    }

    std::vector<ClockStep> steps_;
    bool isDisordered_ = false;
};

/// Returns a sentence for each step of the first few, and one for the number of the others.
std::vector<std::string> clockRemarks(const std::vector<ClockStep>& steps);

}  // namespace terratact
