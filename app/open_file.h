#pragma once

#include <QString>

class QWidget;

namespace terratact {

/// What a file holds, by its content.
enum class FileKind : std::uint8_t {
    Session,  ///< a recorded session
    Scenes,   ///< scenes as CSV
    Log       ///< anything else: a log of candump, or so whoever reads it says
};
FileKind kindOfFile(const QString& path);

/// Asks for a file and opens it in another process of this program, so that nothing that runs here is touched.  Why
/// it could not; empty: it did, or nobody chose one.
QString openInAnotherWindow(QWidget* parent);

}  // namespace terratact
