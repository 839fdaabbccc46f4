#include "core/log/later_poses.h"

#include <stdexcept>
#include <utility>

#include "core/wire/telemetry_listener.h"

namespace terratact {
namespace {

class Follower {
public:
    Follower(SessionReader& session, const RobotModel& robot,
             std::span<const EstimateOfScene> estimates)
        : session_(session), robot_(robot), estimates_(estimates), listener_(robot)
    {
    }

    std::vector<LaterPose> run()
    {
        for (next_ = 0; next_ < session_.scenes().size();) {
            reach();
            follow();
        }
        return std::move(found_);
    }

private:
    struct Track {
        std::size_t estimate;
        EstimateCarrier carrier;
    };

    /// Records where the earlier estimates are at the next scene, and starts to follow that scene's
    /// own estimates.
    void reach()
    {
        for (const Track& track : tracks_)
            if (track.carrier.carried())
                found_.push_back({track.estimate, next_, *track.carrier.carried()});
        const SceneRow& scene = session_.scenes()[next_];
        for (std::size_t k = 0; k < estimates_.size(); ++k)
            if (estimates_[k].scene == next_)
                tracks_.push_back(
                    {k, EstimateCarrier(robot_, *estimates_[k].estimate, scene.measurement)});
        at_ = scene.time;
        ++next_;
    }

    /// Follows up to the next scene, or until nothing is left to follow.
    void follow()
    {
        if (next_ == session_.scenes().size()) return;
        const SessionTime until = session_.scenes()[next_].time;
        for (std::size_t batch = session_.batchAt(at_); batch < session_.batches().size();
             ++batch) {
            std::erase_if(tracks_, [](const Track& track) { return !track.carrier.carried(); });
            if (tracks_.empty() || session_.batches()[batch].first > until) return;
            for (const FrameRow& row : session_.frames(batch))
                if (row.time > at_ && row.time <= until) add(row);
        }
    }

    void add(const FrameRow& row)
    {
        const auto measurement = listener_.receive(row.frame, secondsOf(row.time));
        if (!measurement) return;
        for (Track& track : tracks_) track.carrier.add(*measurement);
    }

    SessionReader& session_;
    const RobotModel& robot_;
    std::span<const EstimateOfScene> estimates_;
    TelemetryListener listener_;
    std::vector<Track> tracks_;
    std::size_t next_ = 0;  ///< index of the next scene
    SessionTime at_ = 0;    ///< time of the scene before it
    std::vector<LaterPose> found_;
};

}  // namespace

std::vector<LaterPose> laterPoses(SessionReader& session, const RobotModel& robot,
                                  std::span<const EstimateOfScene> estimates)
{
    for (const EstimateOfScene& given : estimates)
        if (given.scene >= session.scenes().size())
            throw std::invalid_argument("laterPoses: an estimate of no scene");
    return Follower(session, robot, estimates).run();
}

}  // namespace terratact
