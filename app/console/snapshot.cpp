#include "app/console/snapshot.h"

#include <QBuffer>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>
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
    picture.save(&png, "PNG");
    Status done = writeFileAtomically(files.picture(), png.data().toStdString());
    if (done) done = writeFileAtomically(files.numbers(), numbers);
    return done ? QString() : translated(done.error().message);
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
    QString free = base;
    for (int k = 2; QFileInfo::exists(free + QStringLiteral(".png")); ++k)
        free = base + QLatin1Char('-') + QString::number(k);
    return {free.toStdString()};
}

void SnapshotWriter::write(const SnapshotFiles& files, const QImage& picture, std::string numbers)
{
    if (thread_.joinable()) thread_.join();
    thread_ = std::jthread([this, files, picture, numbers = std::move(numbers)] {
        const QString trouble = writeSnapshot(files, picture, numbers);
        QMetaObject::invokeMethod(
            this,
            [this, base = QString::fromStdString(files.base), trouble] {
                emit wrote(base, trouble);
            },
            Qt::QueuedConnection);
    });
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
    connect(this, &QDialog::accepted, this, [this] {
        if (const QString note = field_->text().trimmed(); !note.isEmpty()) emit noted(note);
    });
}

void SnapshotNote::ask(const QString& name)
{
    name_->setText(name);
    field_->clear();
    show();
    raise();
    activateWindow();
    field_->setFocus();
}

}  // namespace terratact
