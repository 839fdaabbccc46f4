#include "core/strip/strip_ledger.h"

#include <cmath>
#include <stdexcept>

#include "core/base/named.h"

namespace terratact {
namespace {

constexpr auto kScoredByNames = namesOf<ScoredBy>("contact", "probe", "pass");

}  // namespace

std::string_view name(ScoredBy by)
{
    return nameIn(kScoredByNames, by);
}

StripScore& StripScore::operator+=(const StripScore& other)
{
    n += other.n;
    in80 += other.in80;
    sumZ += other.sumZ;
    sumSquares += other.sumSquares;
    return *this;
}

double StripScore::rmsZ() const
{
    return n > 0 ? std::sqrt(sumSquares / static_cast<double>(n)) : 0.0;
}

bool StripLedger::canScore(const HeightBand& predicted, double felt, double feltSd)
{
    const double sd = std::hypot(predicted.sd, feltSd);
    return std::isfinite(felt - predicted.height) && feltSd >= 0.0 && std::isfinite(sd) && sd > 0.0;
}

void StripLedger::add(ScoredBy by, const HeightBand& predicted, double felt, double feltSd)
{
    if (!canScore(predicted, felt, feltSd))
        throw std::invalid_argument("StripLedger: not a measurement");
    const double sd = std::hypot(predicted.sd, feltSd);
    const HeightBand band = widened(predicted, feltSd);
    const double z = (felt - predicted.height) / sd;
    const bool isInside = band.q10 <= felt && felt <= band.q90;
    scores_.at(static_cast<std::size_t>(by)) += {1, isInside ? 1U : 0U, z, z * z};
}

StripLedger& StripLedger::operator+=(const StripLedger& other)
{
    for (std::size_t k = 0; k < scores_.size(); ++k) scores_[k] += other.scores_[k];
    return *this;
}

StripScore StripLedger::all() const
{
    StripScore sum;
    for (const StripScore& score : scores_) sum += score;
    return sum;
}

}  // namespace terratact
