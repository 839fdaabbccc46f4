#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/log/session_rows.h"

namespace terratact {

/// What a session keeps besides frames.
using SessionRow = std::variant<ModelRow, SceneRow, EstimateRow, ProposalRow, EventRow>;

/// What stands at a time of a recording, which the next file begins with: whoever opens that file alone finds what
/// its rows refer to, and sees the console as it was.
class RecordingContext {
public:
    /// A row of the recording, in their order.
    void take(const SessionRow& row);

    /// The model in use; all of the scene that was captured last, the operator's answers to its probes among it; of
    /// arming, link, exploration and a forgotten estimate the newest event, of alarms and contacts each one's; what is
    /// overridden; and whether the robot was unheard since the scene.
    std::vector<SessionRow> rows() const;

private:
    void takeEvent(EventRow event);

    std::vector<SessionRow> ofScene_;  ///< behind the model
    std::map<std::pair<EventKind, std::string>, EventRow> standing_;
};

}  // namespace terratact
