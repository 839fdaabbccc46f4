#include "app/console/past/snapshot.h"

#include <QBuffer>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "core/store/file_write.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"

namespace terratact {
namespace {

/// Writes both files; returns an error text.
QString writeSnapshot(const SnapshotFiles& files, const QImage& picture, const std::string& numbers)
{
    QBuffer png;
    png.open(QIODevice::WriteOnly);
    if (!picture.save(&png, "PNG"))
        return SnapshotWriter::tr("%1: the picture cannot be coded; take the snapshot again")
            .arg(QString::fromStdString(files.picture()));
    if (const Status done = writeFileAtomically(files.picture(), png.data().toStdString()); !done)
        return translated(done.error().message);
    const Status done = writeFileAtomically(files.numbers(), numbers);
    if (done) return {};
    QFile::remove(QString::fromStdString(files.picture()));  // half a snapshot
    return translated(done.error().message);
}

bool isTaken(const SnapshotFiles& files)
{
    return std::ranges::any_of(
        std::array{files.picture(), files.numbers(), files.note()},
        [](const std::string& path) { return QFileInfo::exists(QString::fromStdString(path)); });
}

}  // namespace

QString SnapshotFiles::name() const
{
    return QFileInfo(QString::fromStdString(base)).fileName();
}

SnapshotFiles snapshotFiles(const std::string& session, const QDateTime& utc)
{
    QString base;
    if (session.empty()) {
        QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
        if (!QFileInfo(folder).isDir() || !QFileInfo(folder).isWritable())
            folder = QDir::homePath();
        base = folder + QStringLiteral("/terratact-") + utc.toString(QStringLiteral("yyyyMMdd-"));
    } else {
        const QFileInfo file(QString::fromStdString(session));
        base = file.absolutePath() + QLatin1Char('/') + file.completeBaseName()
             + QStringLiteral("-snapshot-");
    }
    base += utc.toString(QStringLiteral("HHmmss-zzz"));
    SnapshotFiles files{base.toStdString(), session};
    for (int k = 2; isTaken(files); ++k)
        files.base = (base + QLatin1Char('-') + QString::number(k)).toStdString();
    return files;
}

struct SnapshotWriter::Shared {
    std::mutex mutex;
    std::condition_variable ended;
    SnapshotWriter* owner = nullptr;  ///< null: gone
    bool writes = false;
};

SnapshotWriter::SnapshotWriter(QObject* parent) : SnapshotWriter(writeSnapshot, kMaxWait, parent) {}

SnapshotWriter::SnapshotWriter(Write write, std::chrono::milliseconds maxWait, QObject* parent)
    : QObject(parent), write_(std::move(write)), maxWait_(maxWait),
      shared_(std::make_shared<Shared>())
{
    shared_->owner = this;
}

SnapshotWriter::~SnapshotWriter()
{
    std::unique_lock lock(shared_->mutex);
    shared_->owner = nullptr;
    const bool hasEnded =
        shared_->ended.wait_for(lock, maxWait_, [this] { return !shared_->writes; });
    lock.unlock();
    if (!thread_.joinable()) return;
    if (hasEnded)
        thread_.join();
    else
        thread_.detach();
}

bool SnapshotWriter::write(const SnapshotFiles& files, const QImage& picture, std::string numbers)
{
    if (isWriting_) return false;
    isWriting_ = true;
    if (thread_.joinable()) thread_.join();  // it has posted its result and ends
    shared_->writes = true;
    thread_ = std::thread(
        [shared = shared_, write = write_, files, picture, numbers = std::move(numbers)] {
            const QString trouble = write(files, picture, numbers);
            const std::lock_guard lock(shared->mutex);
            shared->writes = false;
            shared->ended.notify_all();
            if (SnapshotWriter* const owner = shared->owner)
                QMetaObject::invokeMethod(
                    owner,
                    [owner, files, trouble] {
                        owner->isWriting_ = false;
                        emit owner->wrote(files, trouble);
                    },
                    Qt::QueuedConnection);
        });
    return true;
}

SnapshotNote::SnapshotNote(QWidget& console) : QDialog(&console)
{
    setWindowTitle(tr("Note on the snapshot"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 14);
    name_ = new PlainLabel(this);
    field_ = new QLineEdit(this);
    field_->setMaxLength(500);
    field_->setMinimumSize(scaled(420), scaled(kTarget));
    field_->setAccessibleName(tr("Note on the snapshot"));
    field_->setPlaceholderText(tr("note; empty: none"));
    auto* buttons = new QDialogButtonBox(this);
    auto* save = buttons->addButton(tr("Save the note"), QDialogButtonBox::AcceptRole);
    auto* none = buttons->addButton(tr("No note"), QDialogButtonBox::RejectRole);
    save->setDefault(true);
    for (QPushButton* const button : {save, none}) button->setMinimumHeight(scaled(kTarget));
    column->addWidget(name_);
    column->addWidget(field_);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::accepted, this, &SnapshotNote::take);
}

void SnapshotNote::take()
{
    const QString note = field_->text().trimmed();
    field_->clear();
    if (note.isEmpty()) return;
    if (!isWritten_)
        early_ = note;
    else
        emit noted(files_, note);
}

void SnapshotNote::setWritten(const QString& text)
{
    isWritten_ = true;
    name_->setText(text);
    if (!early_.isEmpty()) emit noted(files_, std::exchange(early_, {}));
}

void SnapshotNote::ask(const SnapshotFiles& files, const QString& text)
{
    if (isVisible()) take();
    files_ = files;
    isWritten_ = false;
    name_->setText(text);
    field_->clear();
    show();
    raise();
    activateWindow();
    field_->setFocus();
}

}  // namespace terratact
