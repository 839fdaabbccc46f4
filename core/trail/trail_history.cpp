#include "core/trail/trail_history.h"

namespace terratact {

TrailHistory emptyHistory(double pitch, double roll)
{
    TrailHistory history;
    history.pitch.fill(pitch);
    history.roll.fill(roll);
    for (TrailGround& ground : history.ground)
        ground.lowest.fill(std::numeric_limits<double>::infinity());
    return history;
}

}  // namespace terratact
