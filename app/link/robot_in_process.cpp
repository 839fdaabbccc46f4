#include "app/link/robot_in_process.h"

namespace terratact {

TrueHeights trueHeights(const SimulatedRobot& robot)
{
    return {.middle = robot.truth(),
            .sides = {robot.truth(ProbeSide::Left), robot.truth(ProbeSide::Right)}};
}

RobotInProcess::RobotInProcess(MemoryBus& bus, const RobotModel& model, const SimulatedRobot& robot,
                               const RobotOnBus::Options& options,
                               const std::function<double()>& clock)
    : end_(bus.join("robot", 0)), robot_(model, robot, options), truth_(trueHeights(robot)),
      thread_([this, clock](const std::stop_token& stop) {
          const auto keepTruth = [this] {
              const std::scoped_lock lock(mutex_);
              truth_ = trueHeights(robot_.robot());
          };
          (void)serveRobot(  // a MemoryBus never fails
              *end_, robot_, [&] { return !stop.stop_requested(); }, [](const std::string&) {},
              keepTruth, clock);
      })
{
}

TrueHeights RobotInProcess::truth() const
{
    const std::scoped_lock lock(mutex_);
    return truth_;
}

}  // namespace terratact
