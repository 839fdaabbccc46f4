#pragma once

#include <QString>

class QCoreApplication;

namespace terratact {

/// Has the application speak a language from now on: windows built later do.  Returns the one it speaks: "cs", "de",
/// or "en" where there is no translation.  language: "en", "cs" or "de"; empty: the system's.  Numbers have a decimal
/// point and no group separators in every language and whatever the system prefers: they are compared with those of
/// files, frames and other consoles.
QString installLanguage(QCoreApplication& application, const QString& language);

}  // namespace terratact
