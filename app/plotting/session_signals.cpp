#include "app/plotting/session_signals.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "app/plotting/estimate_signals.h"
#include "app/plotting/telemetry_signals.h"
#include "core/log/review_moment.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {
namespace {

constexpr auto kGrowthPeriod = std::chrono::milliseconds(500);
constexpr double kMinSpan = 1.0;  // [s]

bool isEstimateKey(const std::string& key)
{
    return key.starts_with("estimate:");
}

bool needsDraws(const std::string& key)
{
    return key.starts_with("estimate:p_step");
}

}  // namespace

/// The reading half: it belongs to the thread and locks the mutex for moments only.
class SessionSignals::Work {
public:
    Work(SessionSignals& owner, SessionReader reader) : owner_(owner), reader_(std::move(reader)) {}

    /// Reads what is wanted most: a span again, then the next batch. Returns false if there is nothing to do.
    bool step()
    {
        takeOrders();
        if (const auto range = wantedRange()) {
            readDetail(*range);
            return true;
        }
        return readNext();
    }

    /// Reads what a growing session has got since. Returns false if it cannot be read.
    bool grow()
    {
        if (reader_.sealed()) return true;
        const auto more = reader_.refresh();
        if (!more) {
            owner_.fail(more.error().message);
            return false;
        }
        if (!*more) return true;
        const std::scoped_lock lock(owner_.mutex_);
        owner_.end_ = std::max(owner_.end_, secondsOf(reader_.end()));
        orders_ = 0;  // new estimates are read
        return true;
    }

    bool sealed() const { return reader_.sealed(); }
    std::uint64_t orders() const { return orders_ - 1; }  ///< those that were taken

private:
    void takeOrders()
    {
        std::vector<std::string> keys;
        {
            const std::scoped_lock lock(owner_.mutex_);
            if (orders_ == owner_.orders_ + 1) return;
            orders_ = owner_.orders_ + 1;
            keys.reserve(owner_.series_.size());
            next_ = catalogued_;
            for (const Series& s : owner_.series_) {
                keys.push_back(s.key);
                if (!isEstimateKey(s.key)) next_ = std::min(next_, s.next);
            }
            if (book_ != owner_.book_) {
                book_ = owner_.book_;
                catalogued_ = next_ = 0;
            }
        }
        keys_ = std::move(keys);
        frames_.choose(keys_);
        frames_.describe(book_);
        const auto all = telemetrySignals();
        telemetry_.clear();
        frameRate_.reset();
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            for (std::size_t k = 0; k < all.size(); ++k)
                if (all[k].key() == keys_[i]) telemetry_.emplace_back(k, i);
            if (keys_[i] == frameRateKey()) frameRate_ = i;
        }
        listener_.reset();
        readEstimates();
    }

    std::optional<Range> wantedRange() const
    {
        const std::scoped_lock lock(owner_.mutex_);
        return owner_.wanted_;
    }

    /// Decodes the frames of a batch into samples_.
    void decode(std::size_t batch)
    {
        samples_.clear();
        if (!listener_) listener_.emplace(owner_.robot_);
        const SessionBatch& its = reader_.batches()[batch];
        rows_ = reader_.frames(batch);
        for (const FrameRow& row : rows_) {
            const double time = secondsOf(row.time);
            const auto line = listener_->receive(row.frame, time);
            for (std::size_t k = 0; line && k < telemetry_.size(); ++k)
                if (const auto value = telemetryValue(telemetry_[k].first, *line))
                    samples_.push_back({telemetry_[k].second, time, *value});
            values_.clear();
            frames_.decode(row.frame, listener_->judged(), values_);
            for (const FrameSignals::Value& v : values_)
                samples_.push_back({v.signal, time, v.value});
        }
        const double lasts = secondsOf(its.last - its.first);
        if (frameRate_ && lasts > 0.0)
            samples_.push_back(
                {*frameRate_, secondsOf(its.last), static_cast<double>(rows_.size()) / lasts});
    }

    /// Reads the next batch; returns false if there is none.
    bool readNext()
    {
        const std::size_t batches = reader_.batches().size();
        if (next_ >= batches) return false;
        const std::size_t batch = next_++;
        decode(batch);
        const std::scoped_lock lock(owner_.mutex_);
        if (owner_.orders_ + 1 != orders_) return true;  // read again for what is chosen now
        for (const Sample& s : samples_)
            if (Series& series = owner_.series_[s.signal]; series.next == batch)
                series.whole->add(s.time, s.value);
        for (Series& series : owner_.series_)
            if (series.next == batch) series.next = batch + 1;
        for (std::size_t i = 0; batch == catalogued_ && i < rows_.size(); ++i)
            if (owner_.catalogue_.add(rows_[i].frame)) ++owner_.version_;
        if (batch == catalogued_) ++catalogued_;
        owner_.share_ = static_cast<double>(next_) / static_cast<double>(batches);
        constexpr std::size_t kRowsBetweenNews = 64;
        if (next_ % kRowsBetweenNews == 0 || next_ == batches) ++owner_.version_;
        return true;
    }

    /// Reads a span again, for all chosen signals of frames.
    void readDetail(const Range& range)
    {
        const double width = (range.to - range.from) / static_cast<double>(kDetailBuckets);
        std::vector<std::shared_ptr<BucketPyramid>> details;
        details.reserve(keys_.size());
        for (std::size_t i = 0; i < keys_.size(); ++i)
            details.push_back(std::make_shared<BucketPyramid>(range.from, width, kDetailBuckets));
        // A line of telemetry before the span becomes complete in it.
        const std::size_t first = reader_.batchAt(sessionTimeOf(range.from - kReviewWindow));
        std::optional<TelemetryListener> interrupted;
        std::swap(interrupted, listener_);
        for (std::size_t i = first;
             i < reader_.batches().size() && secondsOf(reader_.batches()[i].first) <= range.to;
             ++i) {
            decode(i);
            for (const Sample& s : samples_)
                if (s.time <= range.to) details[s.signal]->add(s.time, s.value);
        }
        std::swap(interrupted, listener_);
        const std::scoped_lock lock(owner_.mutex_);
        if (owner_.wanted_ == range) owner_.wanted_.reset();
        if (owner_.orders_ + 1 != orders_) return;
        for (std::size_t i = 0; i < details.size(); ++i) owner_.series_[i].detail = details[i];
        owner_.detail_ = range;
        ++owner_.version_;
    }

    void readEstimates()
    {
        std::vector<std::size_t> places;
        bool draws = false;
        for (std::size_t i = 0; i < keys_.size(); ++i)
            if (isEstimateKey(keys_[i])) {
                places.push_back(i);
                draws = draws || needsDraws(keys_[i]);
            }
        if (places.empty()) return;
        const auto all = estimateSignals();
        std::vector<std::pair<std::size_t, std::shared_ptr<BucketPyramid>>>
            made;  // index of the signal
        for (const std::size_t i : places)
            for (std::size_t k = 0; k < all.size(); ++k)
                if (all[k].key() == keys_[i]) made.emplace_back(k, owner_.emptyPyramid());
        for (const EstimateRow& row : reader_.estimates()) {
            if (row.role == EstimateRole::Second) continue;
            const auto values = valuesOf(row, draws);
            for (const auto& [k, series] : made)
                if (values[k]) series->add(secondsOf(row.time), *values[k]);
        }
        const std::scoped_lock lock(owner_.mutex_);
        for (const auto& [k, series] : made)
            if (Series* const place = owner_.find(all[k].key())) place->whole = series;
        ++owner_.version_;
    }

    std::vector<std::optional<double>> valuesOf(const EstimateRow& row, bool withDraws)
    {
        const SceneRow* const scene = reader_.scene(row.scene);
        TwoTrackEstimate estimate = row.estimate;
        EstimateFacts facts{.estimate = estimate, .seconds = row.seconds};
        if (scene) facts.truth = truthOf(estimate.onePlane, scene->truth, scene->sideTruth);
        if (!withDraws || !scene) return estimateValues(facts);
        if (auto drawn = reader_.draws(row.id)) {
            setDraws(estimate, std::move(*drawn));
            facts.verdict =
                verdictOf(estimate, owner_.robot_, scene->measurement, {}, row.stepLimit);
        }
        return estimateValues(facts);
    }

    SessionSignals& owner_;
    SessionReader reader_;
    std::uint64_t orders_ = 0;  // 1 + the orders that were taken; 0: none
    std::vector<std::string> keys_;
    std::shared_ptr<const DbcBook> book_;
    FrameSignals frames_;
    std::vector<std::pair<std::size_t, std::size_t>> telemetry_;  // signal and its key
    std::optional<std::size_t> frameRate_;
    std::optional<TelemetryListener> listener_;
    std::size_t next_ = 0;        // batch
    std::size_t catalogued_ = 0;  // batches that are in the catalogue
    std::vector<FrameRow> rows_;  // of one batch
    std::vector<Sample> samples_;
    std::vector<FrameSignals::Value> values_;  // of one frame
};

SessionSignals::SessionSignals(std::string path, const RobotModel& robot, double begin, double end)
    : begin_(begin), robot_(robot), path_(std::move(path)), end_(std::max(end, begin + kMinSpan)),
      thread_([this](const std::stop_token& stop) { run(stop); })
{
}

std::shared_ptr<BucketPyramid> SessionSignals::emptyPyramid() const
{
    const double width = (end_ - begin_) / static_cast<double>(kBuckets - 1);
    return std::make_shared<BucketPyramid>(begin_, width, kBuckets);
}

SessionSignals::Series* SessionSignals::find(const std::string& key)
{
    const auto found =
        std::find_if(series_.begin(), series_.end(), [&](const Series& s) { return s.key == key; });
    return found == series_.end() ? nullptr : &*found;
}

void SessionSignals::fail(Message why)
{
    const std::scoped_lock lock(mutex_);
    trouble_ = std::move(why);
    isIdle_ = true;
    ++version_;
}

void SessionSignals::run(const std::stop_token& stop)
{
    {
        std::unique_lock lock(mutex_);
        if (!wake_.wait(lock, stop, [this] { return isChosen_; })) return;
    }
    auto reader = SessionReader::open(path_);
    if (!reader) return fail(reader.error().message);
    Work work(*this, std::move(*reader));
    while (!stop.stop_requested()) {
        if (work.step()) continue;
        std::unique_lock lock(mutex_);
        const auto hasWork = [&] { return orders_ != work.orders() || wanted_; };
        if (hasWork()) continue;
        isIdle_ = true;
        share_ = 1.0;
        ++version_;
        if (work.sealed())
            wake_.wait(lock, stop, hasWork);
        else
            wake_.wait_for(lock, stop, kGrowthPeriod, hasWork);
        const bool ordered = hasWork();
        if (ordered) isIdle_ = false;
        lock.unlock();
        if (!ordered && !work.grow()) return;
    }
}

void SessionSignals::describe(std::shared_ptr<const DbcBook> book)
{
    const std::scoped_lock lock(mutex_);
    book_ = std::move(book);
    catalogue_.describe(book_);
    for (Series& s : series_)
        if (s.key.starts_with("payload:")) s = {s.key, emptyPyramid()};
    detail_.reset();
    ++orders_;
    ++version_;
    isIdle_ = false;
    wake_.notify_all();
}

std::vector<PlotSignal> SessionSignals::catalogue() const
{
    const std::scoped_lock lock(mutex_);
    return catalogue_.all();
}

void SessionSignals::choose(const std::vector<std::string>& keys)
{
    const std::scoped_lock lock(mutex_);
    std::vector<Series> chosen;
    const std::size_t count = std::min(keys.size(), kMaxChosen);
    chosen.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Series* const kept = find(keys[i]);
        chosen.push_back(kept ? *kept : Series{keys[i], emptyPyramid()});
    }
    series_ = std::move(chosen);
    isChosen_ = true;
    detail_.reset();
    ++orders_;
    ++version_;
    isIdle_ = false;
    wake_.notify_all();
}

SeriesView SessionSignals::view(const std::string& key, const PlotSpan& span)
{
    const std::scoped_lock lock(mutex_);
    Series* const series = find(key);
    if (!series) return {};
    const auto show = [&](const BucketPyramid& pyramid) {
        return viewOf(pyramid, span.from, span.to, span.columns, span.cursor, pyramid.width());
    };
    const double column = (span.to - span.from) / static_cast<double>(span.columns);
    if (column >= series->whole->width() || isEstimateKey(key)) return show(*series->whole);
    const Range range{span.from, span.to};
    const double bucket =
        detail_ ? (detail_->to - detail_->from) / static_cast<double>(kDetailBuckets) : 0.0;
    const bool isFine = detail_ && detail_->covers(range) && bucket <= column;
    if (!isFine) {
        // A quarter of a span more on each side: panning finds it read.
        const double more = 0.25 * (span.to - span.from);
        if (!wanted_ || !wanted_->covers(range)
            || wanted_->to - wanted_->from > 3.0 * (span.to - span.from)) {
            wanted_ = Range{span.from - more, span.to + more};
            isIdle_ = false;
            wake_.notify_all();
        }
        return show(*series->whole);
    }
    if (!series->detail) return show(*series->whole);
    SeriesView view = show(*series->detail);
    if (!view.before) view.before = series->whole->valueAt(span.from);
    if (!detail_->covers({span.cursor, span.cursor}))
        view.atCursor = series->whole->valueAt(span.cursor);
    return view;
}

double SessionSignals::end() const
{
    const std::scoped_lock lock(mutex_);
    return end_;
}

std::uint64_t SessionSignals::version() const
{
    const std::scoped_lock lock(mutex_);
    return version_;
}

double SessionSignals::share() const
{
    const std::scoped_lock lock(mutex_);
    return share_;
}

Message SessionSignals::trouble() const
{
    const std::scoped_lock lock(mutex_);
    return trouble_;
}

bool SessionSignals::isIdle() const
{
    const std::scoped_lock lock(mutex_);
    return isIdle_;
}

}  // namespace terratact
