#include "app/shell/window_picture.h"

#include <QBuffer>
#include <QPixmap>
#include <QWidget>

#include "core/store/file_read.h"
#include "core/store/file_write.h"

namespace terratact {

Status saveWindow(QWidget& window, const std::string& path)
{
    QBuffer png;
    png.open(QIODevice::WriteOnly);
    if (!window.grab().save(&png, "PNG"))
        return fileError(
            path, TR_NOOP("core", "the window's picture could not be made: end other programs"));
    return writeFileAtomically(path, png.data().toStdString());
}

}  // namespace terratact
