#include "app/shell/window_picture.h"

#include <QBuffer>
#include <QPixmap>
#include <QWidget>

#include "core/store/file_write.h"

namespace terratact {

Status saveWindow(QWidget& window, const std::string& path)
{
    QBuffer png;
    png.open(QIODevice::WriteOnly);
    window.grab().save(&png, "PNG");
    return writeFileAtomically(path, png.data().toStdString());
}

}  // namespace terratact
