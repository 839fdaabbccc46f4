#pragma once

#include <optional>
#include <vector>

#include "core/log/review_moment.h"
#include "core/log/session_strip.h"

namespace terratact {

/// The strip of felt ground at a moment of a session. It comes from the file alone (core/log/session_strip.h). It
/// begins kShortest to kShortest + kStep before the moment. If that is before the session's begin, it is the strip that
/// the console showed. Otherwise, it differs from that strip in three points:
///   ground       what was felt before the begin is missing
///   correction   scenes before the begin do not correct the way
///   ledger       is left out, because touches before the begin would be missing
/// So the time of one moment is bounded in a session of any length. The same moment gives the same strip, whatever was
/// asked before. Moving forward or a little back in time is fast.
class ReviewStrip {
public:
    static constexpr double kShortest = 600.0, kStep = 300.0;  ///< [s]

    /// The reader must outlive this object.
    ReviewStrip(SessionReader& reader, RobotModel robot);

    struct ViewState {
        SeenStrip seen{};
        std::vector<EarlierSection> earlier{};  ///< Strip::earlier()
        /// Why nothing is seen. First: nothing was felt since the strip's begin.
        std::optional<SectionStart> why{};
        /// How well bands held up to the moment. Empty: the strip does not begin with the session.
        std::optional<StripLedger> ledger{};
        bool operator==(const ViewState&) const = default;
    };
    ViewState at(const ReviewMoment& moment);

private:
    void begin(SessionTime from);
    void goTo(SessionTime until);

    SessionReader& reader_;
    RobotModel robot_;
    SessionTime from_ = 0;
    /// The strip at several times, oldest first. The last one moves on.
    std::vector<SessionStrip> followed_;
};

}  // namespace terratact
