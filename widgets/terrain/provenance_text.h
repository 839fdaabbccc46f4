#pragma once

#include <QCoreApplication>
#include <QString>
#include <utility>

#include "core/infer/estimate/provenance.h"

namespace terratact {

/// Returns the provenance as a word in the operator's language.
inline QString provenanceWord(Provenance provenance)
{
    const auto word = [](const char* text) {
        return QCoreApplication::translate("terratact::Provenance", text);
    };
    switch (provenance) {
    case Provenance::Arm: return word(QT_TRANSLATE_NOOP("terratact::Provenance", "arm"));
    case Provenance::Contact: return word(QT_TRANSLATE_NOOP("terratact::Provenance", "contact"));
    case Provenance::Constrained:
        return word(QT_TRANSLATE_NOOP("terratact::Provenance", "constrained"));
    case Provenance::Sampled: return word(QT_TRANSLATE_NOOP("terratact::Provenance", "sampled"));
    case Provenance::PriorOnly:
        return word(QT_TRANSLATE_NOOP("terratact::Provenance", "prior only"));
    }
    return {};
}

/// Returns one letter for the provenance; the letters are distinct in every language.
inline QString provenanceLetter(Provenance provenance)
{
    const auto letter = [](const std::pair<const char*, const char*>& source) {
        return QCoreApplication::translate("terratact::Provenance", source.first, source.second);
    };
    switch (provenance) {
    case Provenance::Arm:
        return letter(QT_TRANSLATE_NOOP3("terratact::Provenance", "A", "letter of a mark"));
    case Provenance::Contact:
        return letter(QT_TRANSLATE_NOOP3("terratact::Provenance", "C", "letter of a mark"));
    case Provenance::Constrained:
        return letter(QT_TRANSLATE_NOOP3("terratact::Provenance", "E", "letter of a mark"));
    case Provenance::Sampled:
        return letter(QT_TRANSLATE_NOOP3("terratact::Provenance", "S", "letter of a mark"));
    case Provenance::PriorOnly:
        return letter(QT_TRANSLATE_NOOP3("terratact::Provenance", "P", "letter of a mark"));
    }
    return {};
}

}  // namespace terratact
