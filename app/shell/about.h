#pragma once

#include <QString>
#include <QtGlobal>

namespace terratact {

/// Credit that Qwt's licence requires wherever the program describes itself; English, as in `--version`.
inline constexpr const char* kQwtCredit =
    QT_TRANSLATE_NOOP("About", "Based in part on the work of the Qwt project (http://qwt.sf.net).");

/// Returns name, version and that credit in one line.
QString aboutLine();
/// Returns HTML about the program, its licence and those of its libraries.
QString aboutHtml();

}  // namespace terratact
