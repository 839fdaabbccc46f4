#include "app/shell/open_file.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QProcessEnvironment>
#include <QtEndian>
#include <utility>

#include "app/modelling/truth/truth_file.h"
#include "app/runtime/resources.h"
#include "app/shell/file_dialog.h"
#include "app/shell/remote_stop.h"
#include "core/bags/recording.h"
#include "core/log/rows/session_schema.h"
#include "core/wire/logs/log_reader.h"

namespace terratact {
namespace {

struct OpenFile {
    Q_DECLARE_TR_FUNCTIONS(OpenFile)
};

constexpr qint64 kHead = 4096;            // bytes that are inspected
constexpr qsizetype kApplicationId = 68;  // offset in an SQLite header

}  // namespace

FileKind kindOfFile(const QString& path)
{
    if (!QFileInfo(path).isFile()) return FileKind::Log;  // reading would consume a pipe
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return FileKind::Log;
    const QByteArray head = file.read(kHead);
    if (head.startsWith("SQLite format 3") && head.size() >= kApplicationId + 4) {
        const auto id = qFromBigEndian<quint32>(head.constData() + kApplicationId);
        if (id == static_cast<quint32>(kSessionApplicationId)) return FileKind::Session;
        if (id == static_cast<quint32>(kTruthApplicationId)) return FileKind::Truth;
    }
    for (const char* const magic : {"\x89MCAP", "#ROSBAG", "SQLite format 3"})
        if (head.startsWith(magic)) return FileKind::Recording;
    // Scenes have a header, possibly below comments, in any dialect of core/store/csv_reader.h. No log contains these
    // words.
    if (head.contains("pitch_rad") && head.contains("t_s")) return FileKind::Scenes;
    if (auto log = LogReader::open(path.toStdString()))
        if (const auto first = log->next(); first && *first) return FileKind::Log;
    return openRecording(path.toStdString()) ? FileKind::Recording : FileKind::Log;
}

void openInAnotherWindow(const QString& path, const std::string& stopLine,
                         const std::function<void(const QString& why)>& failed)
{
    QProcess program;
    program.setProgram(QCoreApplication::applicationFilePath());
    program.setArguments({QStringLiteral("--errors-in-window"), path});
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    if (!stopLine.empty())
        environment.insert(QLatin1String(kStopLineVariable), QString::fromStdString(stopLine));
    program.setProcessEnvironment(environment);
    if (!program.startDetached())
        failed(
            OpenFile::tr("%1 could not be opened: a second window could not be started").arg(path));
}

void askAndOpenInAnotherWindow(QWidget& parent, const QString& folder, const std::string& stopLine,
                               std::function<void(const QString& why)> failed)
{
    const QString filter =
        OpenFile::tr("Sessions, logs, scenes, truth files and recordings of other programs "
                     "(*.tts *.log *.asc *.trc *.csv *.gz *.truth "
                     "*.mcap *.bag *.db3);;All files (*)");
    const QString start = QFileInfo(folder).isDir() ? folder : QString();
    askForFile(parent, {.title = OpenFile::tr("Open"), .start = start, .filter = filter},
               [stopLine, failed = std::move(failed)](const QString& path) {
                   openInAnotherWindow(path, stopLine, failed);
               });
}

QStringList demonstrations()
{
    return {QString::fromStdString(resourcePath("sessions/demo.tts")),
            QString::fromStdString(resourcePath("sessions/two_tracks.tts"))};
}

}  // namespace terratact
