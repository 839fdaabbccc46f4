#include "app/imports/open_import.h"

#include <QApplication>

#include "app/imports/import_page.h"
#include "app/imports/import_window.h"
#include "app/recording/session_folder.h"
#include "app/shell/dropped_files.h"
#include "app/shell/open_file.h"
#include "app/shell/window_picture.h"
#include "app/start/console_setup.h"
#include "widgets/base/plain_label.h"

namespace terratact {

Result<int> openImport(Application& application, const ConsoleOptions& options)
{
    LoadedPreferences loaded = preferencesFor(options);
    const auto robot = robotFor(options, loaded);
    if (!robot) return robot.error();
    if (const Status ready =
            application.start(inForce(loaded.preferences, options), options.isPicture());
        !ready)
        return ready.error();
    const QString folder =
        QString::fromStdString(options.sessions.empty() ? sessionFolder() : options.sessions);
    ImportWindow window(QString::fromStdString(options.replay), *robot, folder);
    const auto open = [&window](const QString& path) {
        openInAnotherWindow(
            path, {}, [&window](const QString& why) { window.page()->stateLabel()->setText(why); });
    };
    QObject::connect(&window, &ImportWindow::sessionMade, &window, open);
    openDroppedFiles(window, open);
    showWindow(window, options);
    return QApplication::exec();
}

}  // namespace terratact
