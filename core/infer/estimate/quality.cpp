#include "core/infer/estimate/quality.h"

#include <stdexcept>

#include "core/base/named.h"

namespace terratact {
namespace {

struct Effort {
    int draws, chains, burnIn;
    Precision precision;
    int inducing;
};

Effort effortOf(Quality quality)
{
    switch (quality) {
    case Quality::Fast: return {250, 16, 16, Precision::Single, 175};
    case Quality::Balanced: return {1000, 32, 16, Precision::Single, 300};
    case Quality::Accurate: return {64'000, 8, 50, Precision::Single, 0};  // long chains converge
    }
    throw std::invalid_argument("no such Quality");
}

}  // namespace

std::string_view name(Quality quality)
{
    switch (quality) {
    case Quality::Fast: return "fast";
    case Quality::Balanced: return "balanced";
    case Quality::Accurate: return "accurate";
    }
    throw std::invalid_argument("name: no such Quality");
}

std::optional<Quality> qualityFromName(std::string_view text)
{
    return named(text, kQualities);
}

Settings withQuality(Settings settings, Quality quality)
{
    const Effort effort = effortOf(quality);
    settings.draws = effort.draws;
    settings.chains = effort.chains;
    settings.burnIn = effort.burnIn;
    settings.precision = effort.precision;
    settings.inducing = effort.inducing;
    return settings;
}

}  // namespace terratact
