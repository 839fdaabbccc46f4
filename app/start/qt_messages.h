#pragma once

#include <QString>

namespace terratact {

/// Makes Qt print its messages on stderr, without the control characters of names that they quote. A fatal
/// message ends the program with exit code 1 and one line, instead of a core dump. Messages before windowsCanOpen()
/// are held back, because they belong to that line.
void printQtMessages();

/// Prints what was held back. Call it once QApplication exists.
void windowsCanOpen();

/// Returns the line about a fatal message. before: the messages that were held back.
QString fatalLine(const QString& message, const QStringList& before);

}  // namespace terratact
