#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <string>

class QWidget;

namespace terratact {

/// What a file holds, by its content.
enum class FileKind : std::uint8_t {
    Session,  ///< a recorded session
    Scenes,   ///< scenes as CSV
    Log       ///< anything else: a log of candump, or so whoever reads it says
};
FileKind kindOfFile(const QString& path);

/// Opens a file in another process of this program, so that nothing that runs here is touched.  Does not wait: a file
/// that cannot be read is refused there, in a window.  stopLine: where its STOP goes, see app/shell/remote_stop.h; empty: where
/// that of this program goes.  failed: there is no other process, and why.
void openInAnotherWindow(const QString& path, const std::string& stopLine,
                         const std::function<void(const QString& why)>& failed);

/// Asks for a file, and opens the one that is chosen likewise.  folder: where to look for the first time.
void askAndOpenInAnotherWindow(QWidget& parent, const QString& folder, const std::string& stopLine,
                               std::function<void(const QString& why)> failed);

/// The session that the program brings along; it may be missing.
QString demonstration();

}  // namespace terratact
