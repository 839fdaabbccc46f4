#include "app/shell/dropped_files.h"

#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QObject>
#include <QStringList>
#include <QUrl>
#include <QWidget>
#include <utility>

namespace terratact {
namespace {

constexpr qsizetype kMaxDropped = 8;  // each opens a window

QStringList filesOf(const QDropEvent& event)
{
    QStringList files;
    for (const QUrl& url : event.mimeData()->urls())
        if (url.isLocalFile() && files.size() < kMaxDropped
            && QFileInfo(url.toLocalFile()).isFile())
            files << url.toLocalFile();
    return files;
}

class DroppedFiles final : public QObject {
public:
    DroppedFiles(QWidget& window, std::function<void(const QString& path)> open)
        : QObject(&window), open_(std::move(open))
    {
        window.setAcceptDrops(true);
        window.installEventFilter(this);
    }

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        const bool isDrop = event->type() == QEvent::Drop;
        if (!isDrop && event->type() != QEvent::DragEnter)
            return QObject::eventFilter(watched, event);
        auto& drop = static_cast<QDropEvent&>(*event);  // a DragEnter is one, too
        const QStringList files = filesOf(drop);
        if (files.isEmpty()) return false;
        drop.setDropAction(Qt::CopyAction);
        drop.accept();
        if (isDrop)
            for (const QString& file : files) open_(file);
        return true;
    }

private:
    std::function<void(const QString& path)> open_;
};

}  // namespace

void openDroppedFiles(QWidget& window, std::function<void(const QString& path)> open)
{
    new DroppedFiles(window, std::move(open));  // the window owns it
}

}  // namespace terratact
