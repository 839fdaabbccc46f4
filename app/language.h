#pragma once

#include <QString>

class QCoreApplication;

namespace terratact {

/// Has the application speak a language from now on: windows built later do.  Returns the one it speaks: "cs", "de",
/// or "en" where there is no translation.  language: "en", "cs" or "de"; empty: the system's.
QString installLanguage(QCoreApplication& application, const QString& language);

}  // namespace terratact
