#include "app/recording/recorded_sides.h"

#include "core/log/rows/session_tables.h"

namespace terratact {

std::vector<RecordedSide> recordedSides(bool onePlane, const SceneRow* scene)
{
    if (onePlane)
        return {{.name = kBothSides, .index = 0, .truth = scene ? scene->truth : std::nullopt}};
    const auto truthOf = [scene](std::size_t side) {
        return scene && scene->sideTruth ? std::optional(scene->sideTruth->at(side)) : std::nullopt;
    };
    return {{.name = name(ProbeSide::Left), .index = 0, .truth = truthOf(0)},
            {.name = name(ProbeSide::Right), .index = 1, .truth = truthOf(1)}};
}

}  // namespace terratact
