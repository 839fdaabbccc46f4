#pragma once

#include <QString>
#include <cstdint>
#include <functional>

class QWidget;

namespace terratact {

/// Options of a dialog for a file or a folder.
struct FileWish {
    enum class Kind : std::uint8_t { Existing, ToWrite, Folder };
    QString title;
    /// A path, a file name alone, or the start folder of the first call. Later dialogs with the same title begin where
    /// their last file was. A file name alone is proposed there, and at first in documentsFolder(). A file to write
    /// gets a free name: newFile(). Empty: the last folder of any dialog, else the working directory.
    QString start{};
    QString filter{};  ///< in the format of QFileDialog
    Kind kind = Kind::Existing;
};

/// Shows a file dialog without blocking any window. It leaves the console's header free, so that STOP can be clicked.
/// If a dialog with this title is open, it is raised instead. `chosen` is called once with the path; never if the
/// dialog is cancelled or the parent is destroyed.
void askForFile(QWidget& parent, const FileWish& wish,
                std::function<void(const QString& path)> chosen);

}  // namespace terratact
