#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/log/review_moment.h"
#include "core/log/session_strip.h"

namespace terratact {

/// The strip of felt ground at a moment of a session. It comes from the file alone (core/log/session_strip.h). A strip
/// that begins with the session is whole: it is the one that the console showed. Reading a long session from its begin
/// takes time. readOn() therefore reads in parts and keeps the strip every kStep. In a session of more than
/// kWholes · kStep it keeps fewer. Until it has come near a moment, the moment's strip begins kMinLength to kMinLength + kStep
/// before it. That strip differs from the whole one in three points:
///   ground       ground felt before the begin is missing
///   correction   scenes before the begin do not correct the way
///   ledger       is left out, because touches before the begin would be missing
/// A moment gives the same strip for any order of calls of at(). Moving forward or a little back in time is fast.
class ReviewStrip {
public:
    static constexpr double kMinLength = 600.0, kStep = 300.0;  ///< [s]
    static constexpr double kPart = 10.0;       ///< [s] of the session for each readOn()
    static constexpr std::size_t kWholes = 64;  ///< most strips that readOn() keeps

    /// The reader must outlive this object.
    ReviewStrip(SessionReader& reader, RobotModel robot);

    /// Follows the next part of the session from its begin, as far as it is recorded. Returns true if the strip at
    /// this time has become whole by that.
    bool readOn(SessionTime shown);

    struct ViewState {
        SeenStrip seen{};
        std::vector<EarlierSection> earlier{};  ///< Strip::earlier()
        /// Why nothing is seen. First: nothing was felt since the strip's begin.
        std::optional<SectionStart> why{};
        /// How well bands held up to the moment. Empty: the strip is not whole.
        std::optional<StripLedger> ledger{};
        bool operator==(const ViewState&) const = default;
    };
    ViewState at(const ReviewMoment& moment);

private:
    /// Where the strip of a moment is followed from.
    struct Start {
        SessionTime time = 0;
        bool isWhole = false;
        bool operator==(const Start&) const = default;
    };
    Start startFor(SessionTime time) const;
    void begin(const Start& start);
    void goTo(SessionTime until);

    SessionReader& reader_;
    RobotModel robot_;
    SessionStrip reading_;             ///< readOn() moves it on
    std::vector<SessionStrip> whole_;  ///< the strip at k · apart_
    SessionTime apart_ = sessionTimeOf(kStep);
    Start start_;
    /// The strip at several times since start_, oldest first. The last one moves on.
    std::vector<SessionStrip> followed_;
};

}  // namespace terratact
