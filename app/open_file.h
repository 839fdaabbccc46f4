#pragma once

#include <QString>
#include <cstdint>
#include <functional>

class QWidget;

namespace terratact {

/// What a file holds, by its content.
enum class FileKind : std::uint8_t {
    Session,  ///< a recorded session
    Scenes,   ///< scenes as CSV
    Log       ///< anything else: a log of candump, or so whoever reads it says
};
FileKind kindOfFile(const QString& path);

/// Asks for a file, and opens the one that is chosen in another process of this program, so that nothing that runs here
/// is touched.  Does not wait.  failed: it could not, and why.
void openInAnotherWindow(QWidget& parent, std::function<void(const QString& why)> failed);

}  // namespace terratact
