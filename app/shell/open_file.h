#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <string>

class QWidget;

namespace terratact {

/// Kind of a file, by its content.
enum class FileKind : std::uint8_t {
    Session,    ///< a recorded session
    Scenes,     ///< scenes as CSV
    Truth,      ///< heights of scenes from laser maps
    Recording,  ///< of another program: MCAP, a bag of ROS, CSV with times
    Log         ///< anything else; the log reader decides
};
FileKind kindOfFile(const QString& path);

/// Opens a file in another process of this program and returns at once; this process is not affected. That process
/// shows errors of the file in a window. stopLine: line for its STOP, see app/shell/remote_stop.h; empty: this
/// program's. failed: called with the reason if no process starts.
void openInAnotherWindow(const QString& path, const std::string& stopLine,
                         const std::function<void(const QString& why)>& failed);

/// Asks for a file and opens it with openInAnotherWindow(). folder: initial folder of the first dialog.
void askAndOpenInAnotherWindow(QWidget& parent, const QString& folder, const std::string& stopLine,
                               std::function<void(const QString& why)> failed);

/// Returns the paths of the shipped sessions, of one plane and of two tracks; they may be missing.
QStringList demonstrations();

}  // namespace terratact
