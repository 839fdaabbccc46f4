#include "core/robot/probe_side.h"

#include "core/base/named.h"

namespace terratact {
namespace {

constexpr auto kProbeSideNames = namesOf<ProbeSide>("middle", "left", "right");

}  // namespace

std::string_view name(ProbeSide side)
{
    return nameIn(kProbeSideNames, side);
}

std::optional<ProbeSide> probeSideFromName(std::string_view text)
{
    return valueIn<ProbeSide>(kProbeSideNames, text);
}

}  // namespace terratact
