#pragma once

#include <optional>

namespace terratact {

/// Where a review stands and how it goes on.  Times [s] of the session; it moves by what the caller says has
/// passed, so it has no clock and a pause leaves nothing to catch up with.
class ReviewPlayer {
public:
    static constexpr double kSlowest = 0.05, kFastest = 50.0;
    static constexpr double kMaxStepTime =
        0.25;  ///< [s] of the caller's time that one step may catch up with

    void setRange(double begin, double end);  ///< the position stays within it
    void seek(double seconds);
    /// Goes on from the other end where it stands at one.
    void play(bool backwards);
    void pause() { playing_ = false; }
    void setSpeed(double speed);  ///< data time over the caller's; clamped
    void setLoop(bool on) { loop_ = on; }
    void setA(std::optional<double> seconds) { a_ = seconds; }
    void setB(std::optional<double> seconds) { b_ = seconds; }
    /// At the end of a session that still grows it waits for more instead of pausing.
    void setFollowing(bool on) { following_ = on; }

    /// Lets `elapsed` [s] pass.
    void advance(double elapsed);

    double position() const { return position_; }
    double begin() const { return begin_; }
    double end() const { return end_; }
    double speed() const { return speed_; }
    bool playing() const { return playing_; }
    bool backwards() const { return backwards_; }
    bool following() const { return following_; }
    std::optional<double> a() const { return a_; }
    std::optional<double> b() const { return b_; }
    /// Both cursors are set and it is wanted.
    bool loops() const { return loop_ && a_ && b_ && *a_ != *b_; }
    bool loopWanted() const { return loop_; }

private:
    double begin_ = 0.0, end_ = 0.0, position_ = 0.0, speed_ = 1.0;
    bool playing_ = false, backwards_ = false, loop_ = false, following_ = false;
    std::optional<double> a_, b_;
};

}  // namespace terratact
