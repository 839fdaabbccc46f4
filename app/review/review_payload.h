#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "app/link/dbc_book.h"
#include "app/link/tapped_frame.h"
#include "core/log/session_reader.h"

namespace terratact {

/// Frames of other devices before a time of a session, as the Signals page showed them. The same time always shows the
/// same result, whatever was shown before. The reader must outlive the object.
class ReviewPayload {
public:
    static constexpr double kWindow = 10.0;  ///< [s] window before the time

    explicit ReviewPayload(SessionReader& reader) : reader_(reader) {}

    /// Uses these DBC descriptions from now on; null: none.
    void describe(std::shared_ptr<const DbcBook> book) { book_ = std::move(book); }

    /// Returns the frames of the last kWindow seconds with their rates and extremes, described ones first.
    std::vector<TappedFrame> at(SessionTime time);

private:
    struct Batch {
        std::int64_t id = 0;
        std::vector<FrameRow> frames{};  ///< frames outside the robot's protocol
    };
    const std::vector<FrameRow>& foreignIn(std::size_t batch);

    SessionReader& reader_;
    std::shared_ptr<const DbcBook> book_;
    std::deque<Batch> recent_{};  ///< newest first
};

}  // namespace terratact
