#include "app/start/application.h"

#include <fcntl.h>
#include <unistd.h>

#include <QFontInfo>
#include <QIcon>
#include <QScreen>
#include <QSocketNotifier>
#include <QThread>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/display/units.h"
#include "app/runtime/print_text.h"
#include "app/shell/console_window.h"
#include "app/shell/text_sheet.h"
#include "app/start/language.h"
#include "app/start/qt_messages.h"
#include "core/base/memory_limit.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

constexpr QSize kDefaultSize{1440, 900};

int endingPipe[2] = {-1, -1};

extern "C" void requestEnd(int /*signal*/)
{
    const char byte = 0;
    [[maybe_unused]] const ssize_t written = ::write(endingPipe[1], &byte, 1);
}

void closeOnSignals(ConsoleWindow& window)
{
    if (endingPipe[0] < 0 && ::pipe2(endingPipe, O_CLOEXEC | O_NONBLOCK) != 0) return;
    auto* notifier = new QSocketNotifier(endingPipe[0], QSocketNotifier::Read, &window);
    QObject::connect(notifier, &QSocketNotifier::activated, &window, [&window, notifier] {
        notifier->setEnabled(false);
        window.closeUnasked();
    });
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) std::signal(signal, requestEnd);
}

void setSize(ConsoleWindow& window, const ConsoleOptions& options, const QByteArray& left)
{
    if (options.size)
        window.resize(*options.size);
    else if (left.isEmpty() || !window.restoreGeometry(left))
        window.resize(options.isPicture()
                          ? kDefaultSize
                          : kDefaultSize.boundedTo(window.screen()->availableSize()));
    if (options.isPicture()) window.setRoom(window.size());
}

/// Returns false if no font is installed. Qt then draws a box for every letter.
bool hasFont()
{
    return !QFontInfo(QApplication::font()).family().isEmpty();
}

/// Prints why the program ends. Without memory even for the sentence, it prints nothing.
void printFailure(const std::exception& failure)
{
    try {
        printText(stderr, "terratact-console: {}\n", describeFailure(failure));
    } catch (const std::exception&) {
    }
}

}  // namespace

bool GuardedApplication::notify(QObject* receiver, QEvent* event)
{
    const bool isInLoop = QThread::currentThread() == thread() && thread()->loopLevel() > 0;
    if (isInLoop && hasFailed_) return true;  // a later exit() would replace the code
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::exception& error) {
        if (!isInLoop) throw;
        hasFailed_ = true;
        QApplication::exit(EXIT_FAILURE);
        printFailure(error);
        return true;
    }
}

Status Application::start(const Preferences& preferences, bool pictures)
{
    if (pictures && !std::getenv("QT_QPA_PLATFORM")) setenv("QT_QPA_PLATFORM", "offscreen", 1);
    if (!std::getenv("QT_QPA_PLATFORM") && !std::getenv("DISPLAY")
        && !std::getenv("WAYLAND_DISPLAY"))
        return Error{"no display: set DISPLAY, or use --screenshot FILE"};
    if (!application_) {
        printQtMessages();
        application_.emplace(argc_, argv_);
        windowsCanOpen();
    }
    if (!hasFont())
        return Error{TR_NOOP("Application", "no font is installed, so no text could be read: "
                                            "install one, such as fonts-dejavu-core")};
    QApplication::setApplicationName(QStringLiteral("terratact-console"));
    QApplication::setApplicationDisplayName(QStringLiteral("Terratact"));
    QApplication::setApplicationVersion(QStringLiteral(TERRATACT_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("org.terratact.console"));
    QApplication::setWindowIcon(QIcon::fromTheme(QStringLiteral("org.terratact.console")));
    installLanguage(*application_, preferences.language);
    setUnits(preferences.units);
    applyLook(*application_, preferences.theme, preferences.fontScale);
    return Done{};
}

void printRefusal(const std::string& file, const Message& why)
{
    constexpr int kWide = 620;  // [px] at 100 %
    const QString title =
        file.empty() ? QCoreApplication::translate("Application", "Terratact could not start")
                     : QCoreApplication::translate("Application", "Terratact could not open this");
    TextSheet sheet(title, {Qt::Key_Return, Qt::Key_Enter}, nullptr);
    sheet.setWindowFlags(
        Qt::Window);  // a window of its own on the desktop; closing it ends the program
    sheet.setAttribute(Qt::WA_QuitOnClose);
    sheet.setText(
        QStringLiteral("<h3>%1</h3><p>%2</p>").arg(title, translated(why).toHtmlEscaped()),
        sheet.screen()->availableSize(), scaled(kWide));
    sheet.show();
    QApplication::exec();
}

void showWindow(ConsoleWindow& window, const ConsoleOptions& options, const QByteArray& left)
{
    if (options.safeMode) window.showSafeMode();
    setSize(window, options, left);
    closeOnSignals(window);
    window.show();
}

}  // namespace terratact
