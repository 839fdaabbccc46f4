#include "app/review/export/review_difference.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "app/display/format.h"
#include "core/store/csv_text.h"
#include "widgets/signals/session_timeline.h"

namespace terratact {
namespace {

struct DifferenceWords {
    Q_DECLARE_TR_FUNCTIONS(ReviewDifference)
};

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Formats in the C locale with the fewest digits that read back equal; empty for a missing value.
std::string field(double value)
{
    return std::isfinite(value)
             ? QString::number(value, 'g', QLocale::FloatingPointShortest).toStdString()
             : std::string();
}

/// Returns the known changes of one flipper's forces [N], "--" for others.
QString forceDifferenceText(const Measurement& from, const Measurement& to, bool isLeft)
{
    const auto& before = isLeft ? from.sides.left : from.sides.right;
    const auto& after = isLeft ? to.sides.left : to.sides.right;
    QStringList words;
    for (std::size_t i = 0; i < before.size(); ++i)
        words << format::signedNumber(before[i] && after[i] ? *after[i] - *before[i] : kNone, 1);
    return words.join(QLatin1Char(' '));
}

/// Returns true if left and right changed by other amounts, or the roll changed, beyond the noise of the readings.
bool changedBySides(const Measurement& from, const Measurement& to)
{
    constexpr double kNoise = 0.02;  // [rad]
    const double front = (to.frontLeft - from.frontLeft) - (to.frontRight - from.frontRight);
    const double rear = (to.rearLeft - from.rearLeft) - (to.rearRight - from.rearRight);
    return std::abs(front) > kNoise || std::abs(rear) > kNoise
        || std::abs(to.roll - from.roll) > kNoise;
}

QString sideDifferenceText(const ReviewMoment& a, const ReviewMoment& b)
{
    const Measurement &from = *a.measurement, &to = *b.measurement;
    const QString time = format::signedNumber(secondsOf(b.time - a.time), 3);
    return DifferenceWords::tr(
               "B − A: %1 s, pitch %2, roll %3, front left %4 right %5, rear left %6 "
               "right %7, forces left %8 right %9 N")
        .arg(time, format::angle(to.pitch - from.pitch), format::angle(to.roll - from.roll),
             format::angle(to.frontLeft - from.frontLeft),
             format::angle(to.frontRight - from.frontRight),
             format::angle(to.rearLeft - from.rearLeft),
             format::angle(to.rearRight - from.rearRight), forceDifferenceText(from, to, true),
             forceDifferenceText(from, to, false));
}

}  // namespace

QString differenceText(const ReviewMoment& a, const ReviewMoment& b)
{
    const bool both = a.measurement && b.measurement;
    if (both && changedBySides(*a.measurement, *b.measurement)) return sideDifferenceText(a, b);
    const Measurement from = a.measurement.value_or(Measurement{});
    const Measurement to = b.measurement.value_or(Measurement{});
    const Proprioception first = proprioception(from), second = proprioception(to);
    const auto known = [both](double value) { return both ? value : kNone; };
    QStringList forces;
    for (std::size_t i = 0; i < from.force.size(); ++i)
        forces << format::signedNumber(
            known(shownFeature(to, kFirstForceFeature + i, to.force[i])
                  - shownFeature(from, kFirstForceFeature + i, from.force[i])),
            1);
    return DifferenceWords::tr("B − A: %1 s, pitch %2, front %3, rear %4, forces %5 N")
        .arg(format::signedNumber(secondsOf(b.time - a.time), 3),
             format::angle(known(second.pitch - first.pitch)),
             format::angle(known(second.front - first.front)),
             format::angle(known(second.rear - first.rear)), forces.join(QLatin1Char(' ')));
}

QString numbersCsv(const ReviewMoment& moment)
{
    std::vector<std::string> header{"t_s",           "measured_s",     "pitch_rad",
                                    "roll_rad",      "front_left_rad", "front_right_rad",
                                    "rear_left_rad", "rear_right_rad", "front_left_a",
                                    "front_right_a", "rear_left_a",    "rear_right_a"};
    std::vector<std::string> row{field(secondsOf(moment.time))};
    if (const auto& m = moment.measurement) {
        row.push_back(field(secondsOf(moment.measured)));
        for (const double value :
             {m->pitch, m->roll, m->frontLeft, m->frontRight, m->rearLeft, m->rearRight})
            row.push_back(field(value));
        for (const auto& current : motorCurrents(*m)) row.push_back(field(current.value_or(kNone)));
        for (std::size_t e = 0; e < m->force.size(); ++e)
            row.push_back(field(shownFeature(*m, kFirstForceFeature + e, m->force[e])));
        for (const auto& side : {m->sides.left, m->sides.right})
            for (const auto& force : side) row.push_back(force ? field(*force) : std::string());
    } else {
        row.resize(12 + 3 * kForceElements);
    }
    for (const char* const of : {"", "front_left_", "front_right_"})
        for (int i = 1; i <= kForceElements; ++i)
            header.push_back(of + ("force_" + std::to_string(i)) + "_n");
    return QString::fromStdString(csvLine(header) + csvLine(row));
}

}  // namespace terratact
