#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/infer/provenance.h"

namespace terratact {

/// As an operator reads it, in his language.
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

}  // namespace terratact
