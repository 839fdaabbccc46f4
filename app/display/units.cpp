#include "app/display/units.h"

#include <algorithm>
#include <numbers>

#include "app/display/format.h"

namespace terratact {
namespace {

Units unitsInUse;

constexpr int kCentimetreDecimals = 2;  // decimals of a metre that centimetres take
constexpr int kRadianDecimals = 2;      // decimals more that radians need

bool isCentimetre()
{
    return units().length == LengthUnit::Centimetre;
}

QString lengthText(QString (*made)(double, int), double metres, int decimals)
{
    if (!isCentimetre()) return made(metres, decimals);
    return made(100.0 * metres, std::max(0, decimals - kCentimetreDecimals));
}

QString angleText(QString (*made)(double, int), double radians, int decimals)
{
    if (units().angle == AngleUnit::Radian)
        return made(radians, decimals + kRadianDecimals) + QStringLiteral(" rad");
    return made(radians * 180.0 / std::numbers::pi, decimals) + QStringLiteral("°");
}

}  // namespace

const Units& units()
{
    return unitsInUse;
}

void setUnits(const Units& units)
{
    unitsInUse = units;
}

std::string_view name(LengthUnit unit)
{
    return unit == LengthUnit::Centimetre ? "cm" : "m";
}

std::string_view name(AngleUnit unit)
{
    return unit == AngleUnit::Radian ? "rad" : "deg";
}

QString format::lengthNumber(double metres, int decimals)
{
    return lengthText(&number, metres, decimals);
}

QString format::signedLengthNumber(double metres, int decimals)
{
    return lengthText(&signedNumber, metres, decimals);
}

QString format::lengthUnit()
{
    return isCentimetre() ? QStringLiteral("cm") : QStringLiteral("m");
}

QString format::length(double metres, int decimals)
{
    return lengthNumber(metres, decimals) + QLatin1Char(' ') + lengthUnit();
}

QString format::signedLength(double metres, int decimals)
{
    return signedLengthNumber(metres, decimals) + QLatin1Char(' ') + lengthUnit();
}

QString format::plainAngle(double radians, int decimals)
{
    return angleText(&number, radians, decimals);
}

QString format::angle(double radians, int decimals)
{
    return angleText(&signedNumber, radians, decimals);
}

}  // namespace terratact
