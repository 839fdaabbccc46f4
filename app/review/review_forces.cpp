#include "app/review/review_forces.h"

#include <algorithm>

#include "core/wire/telemetry_listener.h"
#include "widgets/control/robot_readout.h"

namespace terratact {
namespace {

constexpr std::size_t kRecent = 64;  // batches of a quarter of a second each

}  // namespace

const std::vector<TimedForces>& ReviewForces::feltIn(std::size_t batch, double threshold)
{
    const std::int64_t id = reader_.batches()[batch].id;
    const auto found = std::find_if(recent_.begin(), recent_.end(), [&](const Batch& kept) {
        return kept.id == id && kept.threshold == threshold;
    });
    if (found != recent_.end()) return found->felt;
    Batch made{.id = id, .threshold = threshold};
    TelemetryListener listener(robot_);
    ForceArrays arrays(robot_);
    for (std::size_t i = batch - std::min<std::size_t>(batch, 1); i <= batch; ++i)
        for (const FrameRow& row : reader_.frames(i)) {
            const auto measured = listener.receive(row.frame, secondsOf(row.time));
            if (measured && i == batch)
                made.felt.push_back(
                    {secondsOf(row.time), arrays.of(*measured, listener.forces(), threshold)});
        }
    recent_.push_front(std::move(made));
    if (recent_.size() > kRecent) recent_.pop_back();
    return recent_.front().felt;
}

std::vector<TimedForces> ReviewForces::before(SessionTime time, double threshold)
{
    const SessionTime from = time - sessionTimeOf(PeakHold::kHold);
    std::vector<TimedForces> all;
    for (std::size_t i = reader_.batchAt(from);
         i < reader_.batches().size() && reader_.batches()[i].first <= time; ++i)
        for (const TimedForces& felt : feltIn(i, threshold)) {
            const SessionTime at = sessionTimeOf(felt.time);
            if (at < from || at > time) continue;
            if (!all.empty() && felt.time - all.back().time > kStaleAfter) all.clear();
            all.push_back(felt);
        }
    return all;
}

}  // namespace terratact
