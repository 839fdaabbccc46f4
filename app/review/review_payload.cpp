#include "app/review/review_payload.h"

#include <algorithm>

#include "app/link/foreign_frames.h"
#include "core/wire/can_codec.h"

namespace terratact {
namespace {

constexpr std::size_t kRecentBatches = 128;  // batches of a quarter of a second each

bool isForeign(const CanFrame& frame)
{
    const bool mayBeOurs = !frame.error && !frame.extended && !frame.remote && !frame.fd;
    return !mayBeOurs || !kindOfId(frame.id);
}

/// Generates ticks for rates and histories like FrameHistory.
class Ticks {
public:
    Ticks(ForeignFrames& frames, double begin) : frames_(frames), begin_(begin) {}

    void until(double time)
    {
        for (double next = 0.0;
             (next = begin_ + static_cast<double>(count_ + 1) * kBusTick) <= time;) {
            frames_.step(next, count_, point_);
            ++count_;
            point_ = (point_ + 1) % TappedSignal::kPoints;
        }
    }
    std::size_t count() const { return count_; }
    std::size_t point() const { return point_; }

private:
    ForeignFrames& frames_;
    double begin_;  ///< [s]
    std::size_t count_ = 0, point_ = 0;
};

}  // namespace

const std::vector<FrameRow>& ReviewPayload::foreignIn(std::size_t batch)
{
    const std::int64_t id = reader_.batches()[batch].id;
    const auto found = std::find_if(recent_.begin(), recent_.end(),
                                    [id](const Batch& kept) { return kept.id == id; });
    if (found != recent_.end()) return found->frames;
    Batch made{.id = id, .frames = reader_.frames(batch)};
    std::erase_if(made.frames, [](const FrameRow& row) { return !isForeign(row.frame); });
    recent_.push_front(std::move(made));
    if (recent_.size() > kRecentBatches) recent_.pop_back();
    return recent_.front().frames;
}

std::vector<TappedFrame> ReviewPayload::at(SessionTime time)
{
    const SessionTime from = time - sessionTimeOf(kWindow);
    ForeignFrames received;
    (void)received.describe(book_);
    Ticks ticks(received, secondsOf(from));
    for (std::size_t i = reader_.batchAt(from);
         i < reader_.batches().size() && reader_.batches()[i].first <= time; ++i)
        for (const FrameRow& row : foreignIn(i)) {
            if (row.time < from || row.time > time) continue;
            ticks.until(secondsOf(row.time));
            (void)received.add(row.frame, FrameTrouble::Unknown, secondsOf(row.time));
        }
    ticks.until(secondsOf(time));
    std::vector<TappedFrame> frames;
    received.addTo(frames, secondsOf(time), ticks.count(), ticks.point());
    return frames;
}

}  // namespace terratact
