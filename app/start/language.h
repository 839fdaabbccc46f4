#pragma once

#include <QString>

class QCoreApplication;

namespace terratact {

/// Sets the language of windows created later. language: "en", "cs" or "de"; empty: the system's. Returns the language
/// in use: "cs", "de", or "en" without a translation. Numbers always have a decimal point and no group separators. They
/// thus match files, frames and other consoles.
QString installLanguage(QCoreApplication& application, const QString& language);

}  // namespace terratact
