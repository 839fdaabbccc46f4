#pragma once

#include <optional>

namespace terratact {

/// Playback position of a review. Times are seconds of the session. It has no clock: the caller passes the elapsed
/// time, so a pause leaves nothing to catch up with.
class ReviewPlayer {
public:
    static constexpr double kSlowest = 0.05, kFastest = 50.0;
    /// [s] of the caller's time; longer steps are shortened to this.
    static constexpr double kMaxStepTime = 0.25;

    void setRange(double begin, double end);  ///< clamps the position to the range
    void seek(double seconds);
    /// Starts playback; at an end it starts from the other end.
    void play(bool backwards);
    void pause() { playing_ = false; }
    void setSpeed(double speed);  ///< session time per caller's time; clamped
    void setLoop(bool on) { loop_ = on; }
    void setA(std::optional<double> seconds) { a_ = seconds; }
    void setB(std::optional<double> seconds) { b_ = seconds; }
    /// Following: at the end of a growing session the player waits for more instead of pausing.
    void setFollowing(bool on) { following_ = on; }

    /// Advances by `elapsed` [s] of the caller's time.
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
    /// Returns true if looping is switched on and both cursors are set.
    bool loops() const { return loop_ && a_ && b_ && *a_ != *b_; }
    bool loopWanted() const { return loop_; }

private:
    double begin_ = 0.0, end_ = 0.0, position_ = 0.0, speed_ = 1.0;
    bool playing_ = false, backwards_ = false, loop_ = false, following_ = false;
    std::optional<double> a_, b_;
};

}  // namespace terratact
