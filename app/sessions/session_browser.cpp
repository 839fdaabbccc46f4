#include "app/sessions/session_browser.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/sessions/session_details.h"
#include "app/sessions/session_list.h"
#include "app/sessions/session_list_view.h"
#include "app/shell/console_window.h"
#include "app/shell/file_dialog.h"
#include "app/shell/preferences/preference_store.h"
#include "widgets/base/elided_label.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

QString rememberedFolder(const BrowserWish& wish)
{
    const QString remembered = wish.store ? wish.store->current().sessionFolder : QString();
    return QFileInfo(remembered).isDir() ? remembered : wish.folder;
}

}  // namespace

SessionBrowser::SessionBrowser(BrowserWish wish, QWidget* parent)
    : QDialog(parent), wish_(std::move(wish))
{
    setWindowTitle(tr("Recordings"));
    list_ = new SessionList(this);
    sessions_ = new SearchedSessions(*list_, this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    column->setSpacing(8);
    column->addWidget(top());
    table_ = new SessionListView(*sessions_, this);
    setTip(*table_,
           tr("Enter or a double click opens a recording; Alt+1 to Alt+0 sort by a column"));
    column->addWidget(table_, 1);
    details_ = new SessionDetails(this);
    column->addWidget(details_);
    column->addWidget(buttons());

    search_->installEventFilter(this);
    connect(search_, &QLineEdit::textChanged, this, [this](const QString& words) {
        sessions_->search(words);
        chooseFirst();
        showState();
    });
    connect(table_, &QTableView::activated, this, &SessionBrowser::openChosen);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        if (!choosesFirst_) follows_ = false;
        showChosen();
    });
    connect(new QShortcut(Qt::Key_Slash, this), &QShortcut::activated, this, [this] {
        search_->setFocus(Qt::ShortcutFocusReason);
        search_->selectAll();
    });
    showFolder(rememberedFolder(wish_));
    table_->setFocus();
}

SessionBrowser::~SessionBrowser() = default;

QWidget* SessionBrowser::top()
{
    auto* top = new QWidget(this);
    search_ = new QLineEdit(top);
    search_->setAccessibleName(tr("Search the recordings"));
    search_->setPlaceholderText(tr("Search (/): date, robot, verdict, notes, state"));
    search_->setClearButtonEnabled(true);
    search_->setMaxLength(200);
    where_ = new ElidedLabel(top);
    choose_ = new QPushButton(tr("&Folder…"), top);
    setTip(*choose_, tr("Shows the recordings of another folder, also at the next start"));
    auto* row = new QHBoxLayout(top);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(search_, 3);
    row->addWidget(where_, 2);
    row->addWidget(choose_);
    return top;
}

QWidget* SessionBrowser::buttons()
{
    auto* bottom = new QWidget(this);
    state_ = new PlainLabel(bottom);
    state_->setAccessibleName(tr("State of the list"));
    other_ = new QPushButton(tr("O&ther file…"), bottom);
    setTip(*other_, tr("Asks for a session, a log or scenes anywhere"));
    auto* closing = new QPushButton(tr("Close"), bottom);
    open_ = new QPushButton(tr("&Open"), bottom);
    open_->setProperty("role", "primary");
    open_->setDefault(true);
    setTip(*open_, tr("Reviews the chosen recording in another window (Enter)"));
    for (QPushButton* const plain : {choose_, other_, closing}) plain->setAutoDefault(false);
    auto* row = new QHBoxLayout(bottom);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(state_, 1);
    row->addWidget(other_);
    row->addWidget(closing);
    row->addWidget(open_);
    connect(open_, &QPushButton::clicked, this, &SessionBrowser::openChosen);
    connect(closing, &QPushButton::clicked, this, &QDialog::reject);
    connect(choose_, &QPushButton::clicked, this, &SessionBrowser::chooseFolder);
    connect(other_, &QPushButton::clicked, this, [this] {
        const auto ask = wish_.asksForFile;
        close();
        ask();
    });
    return bottom;
}

void SessionBrowser::showFolder(const QString& folder)
{
    reading_.reset();
    folder_ = folder;
    read_ = {};
    list_->clear();
    follows_ = true;
    where_->setText(format::line(folder.toStdString()));
    setTip(*where_, where_->text());
    reading_ = std::make_unique<SessionReading>(folder.toStdString(), wish_.recorded);
    connect(reading_.get(), &SessionReading::news, this, &SessionBrowser::consume);
    reading_->start();
    showState();
}

void SessionBrowser::consume()
{
    SessionReading::News news = reading_->consume();
    list_->add(std::exchange(news.sessions, {}));
    read_ = std::move(news);
    chooseFirst();
    showState();
}

/// Chooses the first row as long as the operator has chosen none.
void SessionBrowser::chooseFirst()
{
    if (!follows_ && table_->currentIndex().isValid()) return;
    choosesFirst_ = true;
    table_->selectRow(0);
    choosesFirst_ = false;
}

/// Shows how many recordings are listed, and which files of the folder are not.
void SessionBrowser::showState()
{
    const int shown = sessions_->rowCount(), known = list_->rowCount();
    QStringList parts;
    if (!read_.trouble.empty())
        parts << translatedLine(read_.trouble);
    else if (!read_.ended)
        parts << tr("reading: %1 of %2 recordings").arg(known).arg(read_.files);
    else if (shown < known)
        parts << tr("%1 of %2 recordings match").arg(shown).arg(known);
    else
        parts << tr("recordings: %1").arg(known);
    if (read_.leftOut > 0) parts << tr("%1 older ones are not listed").arg(read_.leftOut);
    state_->setText(parts.join(QStringLiteral(" · ")));
    showChosen();
}

void SessionBrowser::showChosen()
{
    const int row = table_->currentIndex().row();
    const bool isChosen = row >= 0 && row < sessions_->rowCount();
    open_->setEnabled(isChosen);
    if (isChosen) return details_->show(sessions_->at(row));
    details_->showNothing(!read_.ended            ? tr("The folder is being read …")
                          : list_->rowCount() > 0 ? tr("No recording matches the search.")
                                                  : tr("The folder holds no recording."));
}

void SessionBrowser::openChosen()
{
    const int row = table_->currentIndex().row();
    if (row < 0 || row >= sessions_->rowCount()) return;
    const QString path = QString::fromStdString(sessions_->at(row).path);
    const auto opens = wish_.opens;
    close();
    opens(path);
}

void SessionBrowser::chooseFolder()
{
    askForFile(
        *this,
        {.title = tr("Folder of recordings"), .start = folder_, .kind = FileWish::Kind::Folder},
        [this](const QString& folder) {
            if (wish_.store) wish_.store->change([&](Preferences& p) { p.sessionFolder = folder; });
            showFolder(folder);
        });
}

/// The arrows in the search field move the choice in the table.
bool SessionBrowser::eventFilter(QObject* object, QEvent* event)
{
    if (object == search_ && event->type() == QEvent::KeyPress) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        const int row = std::max(table_->currentIndex().row(), 0);
        const int by = key.key() == Qt::Key_Down ? +1 : key.key() == Qt::Key_Up ? -1 : 0;
        if (by != 0) {
            table_->selectRow(std::clamp(row + by, 0, std::max(sessions_->rowCount() - 1, 0)));
            return true;
        }
    }
    return QDialog::eventFilter(object, event);
}

void browseSessions(QWidget& parent, BrowserWish wish)
{
    for (auto* open : parent.findChildren<SessionBrowser*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!open->isVisible()) continue;  // it is closed and not deleted yet
        open->raise();
        return open->activateWindow();
    }
    auto* browser = new SessionBrowser(std::move(wish), &parent);
    browser->setAttribute(Qt::WA_DeleteOnClose);
    QSize wanted(scaled(1180), scaled(680));
    if (auto* const console = qobject_cast<ConsoleWindow*>(&parent)) {
        browser->resize(wanted.boundedTo(console->roomBelowHeader()));
        console->putBelowHeader(*browser);
    } else {
        browser->resize(wanted);
    }
    browser->show();
    browser->activateWindow();
}

}  // namespace terratact
