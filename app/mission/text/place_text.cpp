#include "app/mission/text/place_text.h"

#include <stdexcept>

#include "app/display/format.h"
#include "app/display/translated.h"

namespace terratact {
namespace {

/// Returns a bin's place in metres: recordings hold the message, and translated() converts it.
Message metresOf(int bin)
{
    return verbatim(format::number(binCentre(bin), 1) + QStringLiteral(" m"));
}

}  // namespace

Message placeMessage(ProbePlace place)
{
    const Message bin = metresOf(place.bin);
    switch (place.side) {
    case ProbeSide::Middle: return {TR_NOOP("terratact::Place", "at %1"), bin};
    case ProbeSide::Left: return {TR_NOOP("terratact::Place", "left at %1"), bin};
    case ProbeSide::Right: return {TR_NOOP("terratact::Place", "right at %1"), bin};
    }
    throw std::invalid_argument("placeMessage: no such side");
}

Message placeName(ProbePlace place)
{
    if (place.side == ProbeSide::Middle) return metresOf(place.bin);
    return placeMessage(place);
}

}  // namespace terratact
