#include "app/shell/file_dialog.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHash>
#include <QLineEdit>
#include <utility>

#include "app/shell/console_window.h"
#include "app/shell/new_file.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

/// Returns the folder of the last chosen file per dialog title.
QHash<QString, QString>& lastFolders()
{
    static QHash<QString, QString> folders;
    return folders;
}

/// Returns the path of the file to propose; empty: none is wanted.
QString startFile(const FileWish& wish)
{
    const QFileInfo start(wish.start);
    if (wish.start.isEmpty() || start.isDir()) return {};
    if (start.fileName() != wish.start) return start.absoluteFilePath();
    return QDir(lastFolders().value(wish.title, documentsFolder())).filePath(wish.start);
}

/// A file dialog without the message boxes of QFileDialog, which would block every window.
class FileDialog final : public QFileDialog {
    Q_DECLARE_TR_FUNCTIONS(FileDialog)
public:
    FileDialog(QWidget& parent, const FileWish& wish) : QFileDialog(&parent, wish.title)
    {
        const bool writes = wish.kind == FileWish::Kind::ToWrite;
        setAcceptMode(writes ? AcceptSave : AcceptOpen);
        const bool isFolder = wish.kind == FileWish::Kind::Folder;
        setFileMode(writes ? AnyFile : isFolder ? Directory : ExistingFile);
        setOption(ShowDirsOnly, isFolder);
        setOption(DontConfirmOverwrite);  // the exporter itself asks about replacing a file
        setOption(ReadOnly);              // no renaming or deleting in this dialog
        setNameFilter(wish.filter);
        setAttribute(Qt::WA_DeleteOnClose);
        const QString proposed = startFile(wish);
        const QString folder = lastFolders().value(wish.title, wish.start);
        if (!proposed.isEmpty())
            selectFile(writes ? newFile(proposed) : proposed);
        else if (!folder.isEmpty())
            setDirectory(folder);
        connect(this, &QFileDialog::fileSelected, this, [title = wish.title](const QString& file) {
            const QFileInfo chosen(file);
            lastFolders()[title] =
                chosen.isDir() ? chosen.absoluteFilePath() : chosen.absolutePath();
        });
        if (auto* const name = findChild<QLineEdit*>(QStringLiteral("fileNameEdit")))
            connect(name, &QLineEdit::textEdited, this,
                    [this, usual = labelText(FileName)] { setLabelText(FileName, usual); });
    }

protected:
    void accept() override
    {
        const QStringList files = selectedFiles();
        const bool missing =
            acceptMode() == AcceptOpen && !files.isEmpty() && !QFileInfo::exists(files.first());
        if (missing) return setLabelText(FileName, tr("There is no file:"));
        QFileDialog::accept();
    }
};

ConsoleWindow* consoleOf(QWidget& widget)
{
    for (QWidget* at = &widget; at; at = at->parentWidget())
        if (auto* const console = qobject_cast<ConsoleWindow*>(at)) return console;
    return nullptr;
}

}  // namespace

void askForFile(QWidget& parent, const FileWish& wish,
                std::function<void(const QString& path)> chosen)
{
    for (auto* open : parent.findChildren<QFileDialog*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!open->isVisible() || open->windowTitle() != wish.title) continue;
        open->raise();
        return open->activateWindow();
    }
    auto* dialog = new FileDialog(parent, wish);
    QObject::connect(dialog, &QFileDialog::fileSelected, &parent, std::move(chosen));
    dialog->resize(dialog->sizeHint().expandedTo(QSize(scaled(760), scaled(440))));
    if (ConsoleWindow* const console = consoleOf(parent)) console->putBelowHeader(*dialog);
    dialog->show();
}

}  // namespace terratact
