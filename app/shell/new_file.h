#pragma once

#include <QString>

namespace terratact {

/// Returns the folder for new files: the user's documents, or the home folder if the documents cannot be written to.
QString documentsFolder();

/// Returns the path, or if a file of that name exists, the first free one of "name-2.ending", "name-3.ending" …
QString newFile(const QString& path);

}  // namespace terratact
