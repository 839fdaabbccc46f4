#include "app/pages/dbc_files.h"

#include <QAction>
#include <QCoreApplication>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <cstdio>
#include <functional>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/link/protocol_dbc.h"
#include "app/runtime/print_text.h"
#include "app/runtime/resources.h"
#include "app/shell/file_dialog.h"
#include "app/shell/preferences/preference_store.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

struct DbcFilesText {
    Q_DECLARE_TR_FUNCTIONS(terratact::SignalsPage)
};

/// Returns a path that may wrap at its folders.
QString breakable(QString text)
{
    return text.replace(QLatin1Char('/'), QStringLiteral("/\u200B"));
}

/// Reads the files; returns empty if the result is no longer wanted.
std::optional<DbcReading> readDbcFiles(const QStringList& paths,
                                       const std::function<bool()>& isWanted)
{
    DbcReading reading;
    auto protocol = readProtocolDbc(resourcePath("dbc/terratact.dbc"));
    if (!protocol) reading.troubles.push_back(protocol.error().message);
    if (protocol) reading.protocol = *std::move(protocol);

    auto book = std::make_shared<DbcBook>();
    for (const QString& path : paths) {
        if (!isWanted()) return std::nullopt;
        const Status added = book->add(path.toStdString());
        if (!added) reading.troubles.push_back(added.error().message);
        reading.files.emplace_back(path, added ? std::optional(book->files().back().frames)
                                               : std::nullopt);
    }
    reading.troubles.insert(reading.troubles.end(), book->remarks().begin(), book->remarks().end());
    reading.book = std::move(book);
    return reading;
}

}  // namespace

DbcFiles::DbcFiles(PreferenceStore& preferences, QWidget& page)
    : QObject(&page), preferences_(preferences), page_(page)
{
    reader_.setMaxThreadCount(1);
    connect(&preferences_, &PreferenceStore::changed, this, [this](const Preferences& before) {
        if (preferences_.current().dbc != before.dbc) read();
    });
}

DbcFiles::~DbcFiles()
{
    ++readings_;
    reader_.clear();
}

void DbcFiles::addButtons(QHBoxLayout& row)
{
    const auto tool = [&row, this](const QString& text, const QString& tip) {
        auto* button = new QPushButton(text, &page_);
        button->setFocusPolicy(Qt::TabFocus);
        button->setMinimumHeight(kTarget);
        setTip(*button, tip);
        row.addWidget(button);
        return button;
    };
    add_ = tool(DbcFilesText::tr("Add DBC file …"),
                DbcFilesText::tr("Adds a DBC file that describes frames of other devices"));
    connect(add_, &QPushButton::clicked, this, &DbcFiles::addFile);
    remove_ = tool(DbcFilesText::tr("Remove DBC file"),
                   DbcFilesText::tr("Its frames are shown byte by byte again"));
    remove_->setMenu(new QMenu(remove_));
}

void DbcFiles::addLines(QVBoxLayout& column)
{
    for (QLabel** label : {&files_, &troubles_}) {
        *label = new PlainLabel(&page_);
        (*label)->setWordWrap(true);
        QSizePolicy policy = (*label)->sizePolicy();  // file names do not widen the page
        policy.setHorizontalPolicy(QSizePolicy::Ignored);
        (*label)->setSizePolicy(policy);
        (*label)->hide();
        column.addWidget(*label);
    }
    files_->setAccessibleName(DbcFilesText::tr("DBC files"));
    troubles_->setAccessibleName(DbcFilesText::tr("Faults of the DBC files"));
    setTone(*troubles_, Tone::Warning);
}

/// Reads in another thread, because a large file takes longer than an armed robot's dead-man timeout.
void DbcFiles::read()
{
    const int job = ++readings_;
    reader_.clear();
    reader_.start([this, job, paths = preferences_.current().dbc] {
        auto reading = readDbcFiles(paths, [this, job] { return job == readings_; });
        if (!reading) return;
        QMetaObject::invokeMethod(
            this,
            [this, job, reading = *std::move(reading)] {
                if (job == readings_) use(reading);
            },
            Qt::QueuedConnection);
    });
}

void DbcFiles::use(const DbcReading& reading)
{
    QStringList files, sentences;
    for (const auto& [path, frames] : reading.files) {
        const QString name = format::fileName(path);
        files << (frames ? DbcFilesText::tr("%1 (frames: %2)").arg(name, QString::number(*frames))
                         : DbcFilesText::tr("%1 (not used)").arg(name));
    }
    for (const Message& trouble : reading.troubles) {
        printText(stderr, "terratact-console: {}\n", trouble.english());
        sentences << translated(trouble);
    }
    show(files, sentences);
    emit wereRead(reading);
}

void DbcFiles::show(const QStringList& files, const QStringList& troubles)
{
    constexpr qsizetype kMaxLines = 3;
    files_->setText(DbcFilesText::tr("DBC files: %1").arg(files.join(QStringLiteral(", "))));
    files_->setVisible(!files.isEmpty());
    QStringList shown;
    for (const QString& trouble : troubles.mid(0, kMaxLines))
        shown << QStringLiteral("▲ ") + breakable(trouble);
    if (troubles.size() > kMaxLines)
        shown << DbcFilesText::tr("… and %1 more, all listed in this tooltip")
                     .arg(troubles.size() - kMaxLines);
    troubles_->setText(shown.join(QLatin1Char('\n')));
    troubles_->setVisible(!troubles.isEmpty());
    setTip(*troubles_, troubles.join(QLatin1Char('\n')));

    add_->setEnabled(files.size() < kMaxDbcFiles);
    remove_->setVisible(!files.isEmpty());
    remove_->menu()->clear();
    for (const QString& path : preferences_.current().dbc) {
        const QAction* remove = remove_->menu()->addAction(QString(path).replace("&", "&&"));
        const auto removed = [this, path] {
            preferences_.change([path](Preferences& p) { p.dbc.removeAll(path); });
        };
        // Queued, because the call rebuilds the menu.
        connect(remove, &QAction::triggered, this, removed, Qt::QueuedConnection);
    }
}

void DbcFiles::addFile()
{
    const FileWish wish{.title = DbcFilesText::tr("Add DBC file"),
                        .filter = DbcFilesText::tr("DBC files (*.dbc *.DBC);;All files (*)")};
    askForFile(page_, wish, [this](const QString& path) {
        preferences_.change([path](Preferences& p) {
            if (!p.dbc.contains(path)) p.dbc << path;
        });
    });
}

QString DbcFiles::files() const
{
    return files_->text();
}

QString DbcFiles::troubles() const
{
    return troubles_->text();
}

}  // namespace terratact
