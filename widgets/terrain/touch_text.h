#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/infer/estimate/touch.h"

namespace terratact {

/// Returns the touch class as a word in the operator's language.
inline QString touchWord(Touch touch)
{
    const auto word = [](const char* text) {
        return QCoreApplication::translate("terratact::Touch", text);
    };
    switch (touch) {
    case Touch::Felt: return word(QT_TRANSLATE_NOOP("terratact::Touch", "felt"));
    case Touch::Remembered: return word(QT_TRANSLATE_NOOP("terratact::Touch", "remembered"));
    case Touch::FeltInPart: return word(QT_TRANSLATE_NOOP("terratact::Touch", "felt in part"));
    case Touch::Bounded: return word(QT_TRANSLATE_NOOP("terratact::Touch", "bounded"));
    case Touch::NotFelt: return word(QT_TRANSLATE_NOOP("terratact::Touch", "not felt"));
    case Touch::Unrecorded: return word(QT_TRANSLATE_NOOP("terratact::Touch", "not recorded"));
    }
    return {};
}

}  // namespace terratact
