#include "app/start/until_closed.h"

#include <QApplication>
#include <QTimer>

#include "app/runtime/print_text.h"
#include "app/shell/dropped_files.h"
#include "app/shell/open_file.h"
#include "app/shell/window_picture.h"
#include "app/start/application.h"

namespace terratact {
namespace {

constexpr int kReadyPeriod = 200;  // [ms] polling period until a window is ready for its picture

}  // namespace

Result<int> untilClosed(ConsoleWindow& window, const ConsoleOptions& options,
                        const std::function<bool()>& isReady)
{
    openDroppedFiles(window, [](const QString& path) {
        openInAnotherWindow(path, {}, [](const QString& why) {
            printText(stderr, "terratact-console: {}\n", why.toStdString());
        });
    });
    showWindow(window, options);
    if (!options.isPicture()) return QApplication::exec();
    Status saved = Done{};
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &window, [&] {
        if (!isReady()) return;
        timer.stop();
        saved = saveWindow(window, options.screenshot);
        QApplication::exit();
    });
    timer.start(kReadyPeriod);
    const int code = QApplication::exec();
    if (!saved) return saved.error();
    return code;
}

}  // namespace terratact
