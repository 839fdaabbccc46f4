#include "core/infer/estimate/quality_preset.h"

#include <stdexcept>

#include "core/base/named.h"

namespace terratact {
namespace {

constexpr auto kQualityPresetNames = namesOf<QualityPreset>("fast", "balanced", "accurate");

struct PresetSettings {
    int draws, chains, burnIn;
    Precision precision;
    int inducing;
};

PresetSettings settingsOf(QualityPreset preset)
{
    switch (preset) {
    case QualityPreset::Fast: return {250, 16, 16, Precision::Single, 175};
    case QualityPreset::Balanced: return {1000, 32, 16, Precision::Single, 300};
    case QualityPreset::Accurate:
        return {64'000, 8, 50, Precision::Single, 0};  // long chains converge
    }
    throw std::invalid_argument("no such QualityPreset");
}

}  // namespace

std::string_view name(QualityPreset preset)
{
    return nameIn(kQualityPresetNames, preset);
}

SourceText describe(QualityPreset preset)
{
    switch (preset) {
    case QualityPreset::Fast: return TR_NOOP("core", "fast");
    case QualityPreset::Balanced: return TR_NOOP("core", "balanced");
    case QualityPreset::Accurate: return TR_NOOP("core", "accurate");
    }
    throw std::invalid_argument("describe: no such QualityPreset");
}

std::optional<QualityPreset> qualityPresetFromName(std::string_view text)
{
    return valueIn<QualityPreset>(kQualityPresetNames, text);
}

Settings withPreset(Settings settings, QualityPreset preset)
{
    const PresetSettings values = settingsOf(preset);
    settings.draws = values.draws;
    settings.chains = values.chains;
    settings.burnIn = values.burnIn;
    settings.precision = values.precision;
    settings.inducing = values.inducing;
    return settings;
}

}  // namespace terratact
