#pragma once

#include <QString>
#include <QtGlobal>

namespace terratact {

/// What the licence of Qwt wants to be read wherever the program says what it is; English, as `--version` has it.
inline constexpr const char* kQwtCredit =
    QT_TRANSLATE_NOOP("About", "Based in part on the work of the Qwt project (http://qwt.sf.net).");

/// Name, version and that credit, in a line.
QString aboutLine();
/// What the program is, its licence and those of the libraries in it; HTML.
QString aboutHtml();

}  // namespace terratact
