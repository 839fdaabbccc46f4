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
    /// A path, a file name, or a folder for the first dialog with this title. Later dialogs with the same title begin
    /// in the folder of their last file. The first dialog with a name only begins in documentsFolder(). newFile() makes
    /// the name of a file to write unique. Empty: the last folder of any dialog, else the working directory.
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
