#pragma once

#include <QString>
#include <cstdint>
#include <functional>

class QWidget;

namespace terratact {

/// Which file is asked for.
struct FileWish {
    enum class Kind : std::uint8_t { Existing, ToWrite };
    QString title;
    /// A file.  Or a folder, for the first time: after that a dialog with this title begins where its last file was.
    /// Empty: likewise, but for the first time with the folder that any dialog had last, or else where the program was
    /// started.
    QString start{};
    QString filter{};  ///< as QFileDialog has it
    Kind kind = Kind::Existing;
};

/// Shows a dialog for a file and does not wait.  It blocks no other window and leaves the header of the console's free,
/// so that STOP can be pressed with the mouse, too.  One with this title that is open already comes to the front
/// instead.  `chosen` is called once with the path; never where none is chosen or the parent has gone.
void askForFile(QWidget& parent, const FileWish& wish,
                std::function<void(const QString& path)> chosen);

}  // namespace terratact
