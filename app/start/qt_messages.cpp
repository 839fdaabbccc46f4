#include "app/start/qt_messages.h"

#include <QMutex>
#include <QStringList>
#include <QtGlobal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

#include "app/runtime/print_text.h"

namespace terratact {
namespace {

QMutex mutex;
std::optional<QStringList> heldBack;  ///< empty: windows can open

void print(const QString& text)
{
    printText(stderr, "terratact-console: {}\n", text.toStdString());
}

void handle(QtMsgType type, const QMessageLogContext& /*context*/, const QString& text)
{
    const QMutexLocker lock(&mutex);
    if (type == QtFatalMsg) {
        print(fatalLine(text, heldBack.value_or(QStringList())));
        std::fflush(stderr);
        std::_Exit(1);
    }
    if (heldBack)
        *heldBack << text;
    else
        print(text);
}

}  // namespace

QString fatalLine(const QString& message, const QStringList& before)
{
    if (!message.contains(QStringLiteral("platform plugin"))) return message;
    QStringList reasons;
    for (const QString& reason : before)
        if (reason.contains(QStringLiteral("display"))
            || reason.contains(QStringLiteral("platform plugin")))
            reasons << reason.trimmed();
    return QStringLiteral("no window can be opened: %1. Check DISPLAY, WAYLAND_DISPLAY and "
                          "QT_QPA_PLATFORM, or use --screenshot FILE")
        .arg(reasons.isEmpty() ? message.section(QLatin1Char('\n'), 0, 0) : reasons.first());
}

void printQtMessages()
{
    heldBack.emplace();
    qInstallMessageHandler(handle);
}

void windowsCanOpen()
{
    const QMutexLocker lock(&mutex);
    for (const QString& text : std::exchange(heldBack, std::nullopt).value_or(QStringList()))
        print(text);
}

}  // namespace terratact
