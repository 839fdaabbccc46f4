#include "app/display/format.h"

#include <QCoreApplication>

namespace terratact {
namespace {

struct FormatText {
    Q_DECLARE_TR_FUNCTIONS(Format)
};

constexpr int kProbabilityDecimals = 2;

}  // namespace

bool format::isExtremeProbability(double p)
{
    const QString shown = number(p, kProbabilityDecimals);
    return shown == number(0.0, kProbabilityDecimals) || shown == number(1.0, kProbabilityDecimals);
}

QString format::probability(double p)
{
    if (!isExtremeProbability(p)) return number(p, kProbabilityDecimals);
    return p > 0.5 ? FormatText::tr("more than %1").arg(number(0.99, kProbabilityDecimals))
                   : FormatText::tr("less than %1").arg(number(0.01, kProbabilityDecimals));
}

QString format::probability(double p, double monteCarloSd)
{
    return isExtremeProbability(p)
             ? probability(p)
             : QStringLiteral("%1 ± %2").arg(probability(p),
                                             randomError(monteCarloSd, kProbabilityDecimals));
}

}  // namespace terratact
