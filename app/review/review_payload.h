#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "app/link/dbc_book.h"
#include "app/link/tapped_frame.h"
#include "core/log/session_reader.h"

namespace terratact {

/// What other devices than the robot had sent on the bus before a time of a session, as the page Signals had it.  The
/// same time shows the same, however one came there.  The reader must outlive it.
class ReviewPayload {
public:
    static constexpr double kWindow = 10.0;  ///< [s] before the time

    explicit ReviewPayload(SessionReader& reader) : reader_(reader) {}

    /// From now on; null: no DBC files.
    void describe(std::shared_ptr<const DbcBook> book) { book_ = std::move(book); }

    /// Of the last kWindow seconds, with rates and extremes of them; described ones first.
    std::vector<TappedFrame> at(SessionTime time);

private:
    struct Batch {
        std::int64_t id = 0;
        std::vector<FrameRow> frames{};  ///< that are none of the robot's
    };
    const std::vector<FrameRow>& foreignIn(std::size_t batch);

    SessionReader& reader_;
    std::shared_ptr<const DbcBook> book_;
    std::deque<Batch> recent_{};  ///< the newest in front
};

}  // namespace terratact
