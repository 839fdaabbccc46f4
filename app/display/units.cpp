#include "app/display/units.h"

#include <algorithm>
#include <numbers>

#include "app/display/format.h"

namespace terratact {
namespace {

Units unitsInUse;

constexpr int kCentimetreDecimals = 2;  // decimals of a metre that centimetres take
constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr int kRadianDecimals = 2;  // decimals more that radians need

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
    return made(kDegreesPerRadian * radians, decimals) + QStringLiteral("°");
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

ShownUnit shownUnit(std::string_view si)
{
    const std::string_view unit = si.substr(0, si.find('/'));
    const QString rest = format::line(si.substr(unit.size()));
    if (rest.isEmpty() || rest == QLatin1String("/s")) {
        if (unit == "m" && isCentimetre()) return {QStringLiteral("cm") + rest, 100.0};
        if (unit == "rad" && units().angle == AngleUnit::Degree)
            return {QStringLiteral("°") + rest, kDegreesPerRadian};
    }
    return {format::line(si)};
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
