#include "app/shell/new_file.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace terratact {

QString documentsFolder()
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QFileInfo folder(documents);
    return folder.isDir() && folder.isWritable() ? documents : QDir::homePath();
}

QString newFile(const QString& path)
{
    const QFileInfo file(path);
    const auto isTaken = [](const QString& at) {
        const QFileInfo info(at);
        return info.exists() || info.isSymLink();  // a link may lead nowhere
    };
    QString free = path;
    for (int number = 2; isTaken(free); ++number) {
        const QString ending =
            file.suffix().isEmpty() ? QString() : QLatin1Char('.') + file.suffix();
        free = file.dir().filePath(
            QStringLiteral("%1-%2%3").arg(file.completeBaseName()).arg(number).arg(ending));
    }
    return free;
}

}  // namespace terratact
