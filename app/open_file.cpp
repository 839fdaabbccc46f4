#include "app/open_file.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileDialog>
#include <QProcess>
#include <QtEndian>

#include "core/log/session_schema.h"

namespace terratact {
namespace {

struct OpenFile {
    Q_DECLARE_TR_FUNCTIONS(OpenFile)
};

constexpr qint64 kHead = 4096;            // bytes to judge by
constexpr qsizetype kApplicationId = 68;  // of an SQLite file, see its format

}  // namespace

FileKind kindOfFile(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return FileKind::Log;
    const QByteArray head = file.read(kHead);
    if (head.startsWith("SQLite format 3") && head.size() >= kApplicationId + 4
        && qFromBigEndian<quint32>(head.constData() + kApplicationId)
               == static_cast<quint32>(kSessionApplicationId))
        return FileKind::Session;
    const QByteArray line = head.left(head.indexOf('\n'));
    return line.contains("pitch_rad") && line.contains(',') ? FileKind::Scenes : FileKind::Log;
}

QString openInAnotherWindow(QWidget* parent)
{
    const QString path = QFileDialog::getOpenFileName(
        parent, OpenFile::tr("Open"), {},
        OpenFile::tr("Sessions, logs and scenes (*.tts *.log *.csv);;All files (*)"));
    if (path.isEmpty()) return {};
    if (QProcess::startDetached(QCoreApplication::applicationFilePath(), {path})) return {};
    return OpenFile::tr("%1 could not be opened: this program could not be started again")
        .arg(path);
}

}  // namespace terratact
