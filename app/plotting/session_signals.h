#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/plotting/frame_signals.h"
#include "app/plotting/plot_source.h"
#include "app/plotting/signal_catalogue.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"
#include "core/series/bucket_pyramid.h"

namespace terratact {

/// The plotted signals of a session. A thread with its own reader reads the whole file once for
/// newly chosen signals, and keeps kBuckets of each. If a span needs a finer resolution, the thread
/// reads that span again. Until then, view() shows the buckets. It follows a session that still
/// grows. Nothing is read before the first choose().
class SessionSignals final : public PlotSource {
public:
    static constexpr std::size_t kBuckets = 65'536;  ///< of the whole session: 4 MB for each signal
    static constexpr std::size_t kDetailBuckets = 8'192;  ///< of a span that was read again

    /// begin, end: of the session [s]. The thread opens the file.
    SessionSignals(std::string path, const RobotModel& robot, double begin, double end);

    /// Uses these DBC descriptions from now on; null: none. Payload signals are read again.
    void describe(std::shared_ptr<const DbcBook> book);

    std::vector<PlotSignal> catalogue() const override;
    void choose(const std::vector<std::string>& keys) override;
    SeriesView view(const std::string& key, const PlotSpan& span) override;
    double begin() const override { return begin_; }
    double end() const override;
    std::uint64_t version() const override;
    double share() const override;
    Message trouble() const override;
    /// Returns true if all chosen signals are read, and no span must be read again.
    bool isIdle() const;

private:
    struct Series {
        std::string key;
        std::shared_ptr<BucketPyramid> whole, detail{};  // detail: null if none is read
        std::size_t next = 0;                            // first batch that is not in it
    };
    struct Range {
        double from = 0.0, to = 0.0;
        bool covers(const Range& other) const { return from <= other.from && other.to <= to; }
        bool operator==(const Range&) const = default;
    };
    struct Sample {
        std::size_t signal;
        double time, value;
    };
    class Work;  // of the thread
    void run(const std::stop_token& stop);
    void fail(Message why);
    std::shared_ptr<BucketPyramid> emptyPyramid() const;
    /// Returns the series of a key; null: it is not chosen. Call with the mutex locked.
    Series* find(const std::string& key);

    const double begin_;
    const RobotModel robot_;
    const std::string path_;
    mutable std::mutex mutex_;  // guards the members below
    std::condition_variable_any wake_;
    double end_;
    std::vector<Series> series_;
    std::shared_ptr<const DbcBook> book_;
    std::uint64_t orders_ = 0;  // number of changes of what is chosen or described
    bool isChosen_ = false;     // choose() was called
    std::optional<Range> wanted_{}, detail_{};
    SignalCatalogue catalogue_;
    double share_ = 0.0;
    bool isIdle_ = false;
    Message trouble_;
    std::uint64_t version_ = 1;
    std::jthread thread_;  // last member: the thread starts after all others exist
};

}  // namespace terratact
