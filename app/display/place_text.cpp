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

QString placeText(int bin, ProbeSide side)
{
    const QString name = format::binName(bin);
    switch (side) {
    case ProbeSide::Middle: return PlaceWords::tr("at %1").arg(name);
    case ProbeSide::Left: return PlaceWords::tr("left at %1").arg(name);
    case ProbeSide::Right: return PlaceWords::tr("right at %1").arg(name);
    }
    return name;
}

QString placeName(int bin, ProbeSide side)
{
    const QString name = format::binName(bin);
    if (side == ProbeSide::Middle) return name;
    return sideLetter(side == ProbeSide::Left ? Side::Left : Side::Right) + QLatin1Char(' ') + name;
}

}  // namespace terratact
