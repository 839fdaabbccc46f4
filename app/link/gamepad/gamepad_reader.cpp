#include "app/link/gamepad/gamepad_reader.h"

#include <exception>
#include <utility>

namespace terratact {

GamepadReader::GamepadReader(std::unique_ptr<Gamepad> gamepad, MeasurementSource& source,
                             Clock clock)
    : gamepad_(std::move(gamepad)), source_(source), clock_(std::move(clock)),
      thread_([this](const std::stop_token& stop) { read(stop); })
{
}

void GamepadReader::read(const std::stop_token& stop)
{
    PadFollower follower;
    while (!stop.stop_requested()) {
        const GamepadState state = poll();
        bool sends = false, pressed = false;
        {
            const std::scoped_lock lock(mutex_);
            pressed = follower.poll(state, settings_, false).stop;
            sends = sends_ && pressed;
            latest_ = state;
            readAt_ = clock_();
            stops_ += pressed ? 1 : 0;
        }
        // The window sends it again and reports what hinders it.
        if (sends) (void)source_.send(StopCommand{});
    }
}

GamepadState GamepadReader::poll()
{
    try {
        return gamepad_->poll(kPeriod);
    } catch (const std::exception& error) {
        std::this_thread::sleep_for(kPeriod);  // a gamepad that fails at once must not busy-loop
        GamepadState lost;
        lost.trouble = messageOf(error);
        return lost;
    }
}

GamepadState GamepadReader::latest(double now) const
{
    const std::scoped_lock lock(mutex_);
    if (now - readAt_ <= kFreshFor) return latest_;
    GamepadState lost;
    lost.trouble = latest_.trouble;
    return lost;
}

void GamepadReader::setStop(const PadMapping& mapping, bool sends)
{
    const std::scoped_lock lock(mutex_);
    settings_.mapping = mapping;
    sends_ = sends;
}

int GamepadReader::consumeStops()
{
    const std::scoped_lock lock(mutex_);
    return std::exchange(stops_, 0);
}

}  // namespace terratact
