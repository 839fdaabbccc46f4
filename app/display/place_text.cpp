#include "app/display/place_text.h"

#include <QCoreApplication>

#include "app/display/format.h"

namespace terratact {
namespace {

struct PlaceWords {
    Q_DECLARE_TR_FUNCTIONS(Place)
};

}  // namespace

QString sideLetter(Side side)
{
    return side == Side::Left ? PlaceWords::tr("L") : PlaceWords::tr("R");
}

QString sideWord(Side side)
{
    return side == Side::Left ? PlaceWords::tr("left") : PlaceWords::tr("right");
}

QString placeText(ProbePlace place)
{
    QString name = format::binName(place.bin);
    switch (place.side) {
    case ProbeSide::Middle: return PlaceWords::tr("at %1").arg(name);
    case ProbeSide::Left: return PlaceWords::tr("left at %1").arg(name);
    case ProbeSide::Right: return PlaceWords::tr("right at %1").arg(name);
    }
    return name;
}

QString binText(ProbePlace place)
{
    QString name = format::binName(place.bin);
    switch (place.side) {
    case ProbeSide::Middle: return PlaceWords::tr("bin %1").arg(name);
    case ProbeSide::Left: return PlaceWords::tr("left bin %1").arg(name);
    case ProbeSide::Right: return PlaceWords::tr("right bin %1").arg(name);
    }
    return name;
}

QString sidePlace(ProbePlace place)
{
    const bool hasSide = place.side != ProbeSide::Middle;
    return shortPlace(place) + (hasSide ? QLatin1Char(' ') + format::lengthUnit() : QString());
}

QString shortPlace(ProbePlace place)
{
    QString name = format::binName(place.bin);
    if (place.side == ProbeSide::Middle) return name;
    return sideLetter(place.side == ProbeSide::Left ? Side::Left : Side::Right) + QLatin1Char(' ')
         + format::lengthNumber(binCentre(place.bin), 1);
}

}  // namespace terratact
