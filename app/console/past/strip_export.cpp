#include "app/console/past/strip_export.h"

#include <QFileInfo>
#include <memory>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/figures/report/strip_file.h"
#include "app/mission/exploration.h"
#include "app/shell/file_dialog.h"

namespace terratact {

StripExport::StripExport(const Exploration& exploration, const RobotModel& robot, QWidget& window)
    : QObject(&window), exploration_(exploration), robot_(robot), window_(window)
{
}

void StripExport::ask()
{
    if (exploration_.estimation().strip().sections().empty())
        return emit refused(TR_NOOP("terratact::StripExport",
                                    "no strip to export: nothing was estimated yet, or the robot "
                                    "reports no odometry"));
    askForFile(window_,
               {.title = tr("Export the strip of felt ground"),
                .start = QStringLiteral("strip.svg"),
                .filter = tr("Pictures (*.svg *.png *.pdf *.html)") + QStringLiteral(";;")
                        + tr("Profile (*.csv)") + QStringLiteral(";;") + tr("Point cloud (*.ply)"),
                .kind = FileWish::Kind::ToWrite},
               [this](const QString& path) { write(path); });
}

void StripExport::write(const QString& path)
{
    if (isWriting_)
        return emit refused(
            TR_NOOP("terratact::StripExport", "a strip is still being written: try again"));
    const QString file = QFileInfo(path).suffix().isEmpty() ? path + QStringLiteral(".svg") : path;
    if (QFileInfo::exists(file))
        return emit refused({TR_NOOP("terratact::StripExport",
                                     "%1 exists and was not replaced; choose another name"),
                             file.toStdString()});
    isWriting_ = true;
    // The last thread ends as soon as it has posted its result, so this waits for nothing.
    thread_ =
        std::jthread([this, file, robot = robot_,
                      strip = std::make_shared<const Strip>(exploration_.estimation().strip())] {
            const Status done =
                writeStrip(file.toStdString(), strip, robot, inReadersLanguage(stripTitle({})), {},
                           inReadersLanguage);
            const QString trouble = done ? QString() : translated(done.error().message);
            QMetaObject::invokeMethod(
                this, [this, file, trouble] { finish(file, trouble); }, Qt::QueuedConnection);
        });
}

void StripExport::finish(const QString& path, const QString& trouble)
{
    isWriting_ = false;
    if (!trouble.isEmpty()) return emit refused(verbatim(trouble));
    emit wrote({TR_NOOP("terratact::StripExport", "strip of felt ground written: %1"),
                path.toStdString()});
}

}  // namespace terratact
