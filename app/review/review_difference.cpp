#include "app/review/review_difference.h"

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

}  // namespace

QString differenceWords(const ReviewMoment& a, const ReviewMoment& b)
{
    const bool both = a.measurement && b.measurement;
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
             format::degrees(known(second.pitch - first.pitch)),
             format::degrees(known(second.front - first.front)),
             format::degrees(known(second.rear - first.rear)), forces.join(QLatin1Char(' ')));
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
        const auto put = [&](std::size_t feature, double value) {
            row.push_back(m->missing[feature] ? std::string() : field(value));
        };
        put(kFrontCurrentFeature, m->frontLeftCurrent);
        put(kFrontCurrentFeature, m->frontRightCurrent);
        put(kRearCurrentFeature, m->rearLeftCurrent);
        put(kRearCurrentFeature, m->rearRightCurrent);
        for (std::size_t e = 0; e < m->force.size(); ++e) put(kFirstForceFeature + e, m->force[e]);
    } else {
        row.resize(12 + kForceElements);
    }
    for (int i = 1; i <= kForceElements; ++i) header.push_back("force_" + std::to_string(i) + "_n");
    return QString::fromStdString(csvLine(header) + csvLine(row));
}

}  // namespace terratact
