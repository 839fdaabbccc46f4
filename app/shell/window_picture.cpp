#include "app/shell/window_picture.h"

#include <QBuffer>
#include <QPixmap>
#include <QWidget>

#include "app/shell/console_window.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"

namespace terratact {

QPixmap pictureOf(QWidget& widget)
{
    if (auto* const window = qobject_cast<ConsoleWindow*>(widget.window())) window->finishFitting();
    return widget.grab();
}

Status saveWindow(QWidget& window, const std::string& path)
{
    QBuffer png;
    png.open(QIODevice::WriteOnly);
    if (!pictureOf(window).save(&png, "PNG"))
        return fileError(
            path, TR_NOOP("core", "the window's picture could not be made: end other programs"));
    return writeFileAtomically(path, png.data().toStdString());
}

}  // namespace terratact
