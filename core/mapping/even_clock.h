#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace terratact {

/// A place where the clock of a recording was set.
struct ClockStep {
    std::int64_t time = 0;    ///< [ns] on the even clock
    double back = 0.0;        ///< [s]; negative: set forward
    std::uint64_t shift = 0;  ///< what is added to later times [ns], modulo 2^64
};

/// Messages of a topic may come out of order by kMaxDisorder [s]. Rows of a table may by kMaxJitter
/// [s], and a single row by kMaxDisorder.
inline constexpr double kMaxDisorder = 1.0, kMaxJitter = 1e-3;

/// Returns by how much `time` lies before `before` [s] if the clock was set between them. Empty: it
/// was not. The clock was set if it went back by more than `disorder` [s], or forward by more than
/// ten years.
std::optional<double> clockStepBetween(std::int64_t before, std::int64_t time,
                                       double disorder = kMaxDisorder);

/// Makes the times of series even that were recorded while the clock was set. All series share
/// their steps, so that their values stay together. Columns of a table share those of its rows.
class EvenClock {
public:
    static constexpr std::size_t kMaxSteps = 16;  ///< more falls: the values are not in order

    EvenClock() = default;
    EvenClock(const EvenClock&) = delete;
    EvenClock& operator=(const EvenClock&) = delete;

    /// Follows the time of the next row of a table [ns]. Each list of samples may lack those of some
    /// rows. eachList(visit) calls visit(samples) with every list, without the samples of this row. The order is that
    /// of the later calls of make().
    template <class EachList>
    void addRow(std::int64_t time, EachList eachList)
    {
        if (isDisordered_) return;
        if (const auto late = std::exchange(late_, {}); late && time < *rows_.before) follow(*late);
        const auto back =
            rows_.before ? clockStepBetween(*rows_.before, time, kMaxJitter) : std::nullopt;
        Row row{.time = time};
        if (back) eachList([&row](const auto& samples) { row.sizes.push_back(samples.size()); });
        if (back && *back > 0.0 && *back <= kMaxDisorder)
            late_ = std::move(row);
        else
            follow(row);
    }

    /// Shifts the times of samples, which are in the file's order. Leaves them where there are more
    /// than kMaxSteps steps.
    template <class Samples>
    void make(Samples& samples)
    {
        if (rows_.before) return makeByRows(samples);
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
        double disorder = kMaxDisorder;
        std::optional<std::int64_t> before{};
        std::int64_t interval = 1;
        std::uint64_t shift = 0;
        std::size_t steps = 0;

        std::int64_t add(std::int64_t time);
    };

private:
    struct Row {
        std::int64_t time = 0;             ///< [ns]
        std::vector<std::size_t> sizes{};  ///< of each list before the row, if it is a step
    };

    /// Adds a row whose place in the order is known.
    void follow(const Row& row);

    template <class Samples>
    static std::size_t steps(const Samples& samples)
    {
        std::size_t count = 0;
        for (std::size_t i = 1; i < samples.size(); ++i)
            count += clockStepBetween(samples[i - 1].time, samples[i].time) ? 1 : 0;
        return count;
    }

    /// Returns a time that a step shifts. The sum is modulo 2^64.
    static std::int64_t shifted(std::int64_t time, std::uint64_t shift)
    {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(time) + shift);
    }

    template <class Samples>
    void makeByRows(Samples& samples)
    {
        for (std::size_t k = 0; k < sizes_.size(); ++k)
            for (std::size_t i = sizes_[k].at(made_); i < samples.size(); ++i)
                samples[i].time = shifted(samples[i].time, steps_[k].shift);
        ++made_;
    }

    std::vector<ClockStep> steps_;
    bool isDisordered_ = false;
    Follower rows_{.clock = *this, .disorder = kMaxJitter};
    std::optional<Row> late_;  ///< a step, if the next row also lies before the one ahead of it
    std::vector<std::vector<std::size_t>> sizes_;  ///< of each list, at each step of the rows
    std::size_t made_ = 0;                         ///< lists that makeByRows() has shifted
};

/// Returns a sentence for each step of the first few, and one for the number of the others.
std::vector<std::string> clockRemarks(const std::vector<ClockStep>& steps);

}  // namespace terratact
