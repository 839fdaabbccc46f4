#include "app/imports/import_page.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <utility>

#include "app/display/format.h"
#include "app/runtime/resources.h"
#include "app/shell/file_dialog.h"
#include "core/base/text.h"
#include "core/store/file_read.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxMappingBytes = std::size_t{64} * 1024;
constexpr int kResultLines = 4;

/// Returns a text whose Tab key goes to the next control, under its name.
QPlainTextEdit* textOf(const QString& name, bool isEdited, QWidget* parent)
{
    auto* text = new QPlainTextEdit(parent);
    text->setAccessibleName(name);
    text->setTabChangesFocus(true);
    text->setReadOnly(!isEdited);
    text->setLineWrapMode(isEdited ? QPlainTextEdit::NoWrap : QPlainTextEdit::WidgetWidth);
    // A text that is only read can be scrolled by keys, too.
    if (!isEdited)
        text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return text;
}

QWidget* under(const QString& title, QPlainTextEdit* text, QWidget* parent)
{
    auto* column = new QWidget(parent);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins({});
    auto* label = new PlainLabel(title, column);
    label->setBuddy(text);
    layout->addWidget(label);
    layout->addWidget(text, 1);
    return column;
}

}  // namespace

ImportPage::ImportPage(const QString& file, const RobotFile& robot, QString folder, QWidget* parent)
    : QWidget(parent), file_(file), folder_(std::move(folder)),
      work_(new ImportWork(file.toStdString(), robot, this))
{
    build();
    connectWork();
    showBusy(tr("Reading %1 …").arg(format::fileName(file_)));
    work_->survey();
}

void ImportPage::build()
{
    holds_ = textOf(tr("What the recording holds"), false, this);
    mapping_ = textOf(tr("Mapping: which topic and field is which sensor"), true, this);
    result_ = textOf(tr("What is missing or doubtful"), false, this);
    result_->setMaximumHeight(result_->fontMetrics().lineSpacing() * (kResultLines + 1));
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->setChildrenCollapsible(false);
    split->addWidget(under(tr("The recording h&olds"), holds_, split));
    split->addWidget(under(tr("&Mapping: correct it where it is wrong"), mapping_, split));

    choice_ = new QComboBox(this);
    choice_->setAccessibleName(tr("Where the mapping comes from"));
    choice_->addItem(tr("proposed mapping"));
    for (const QFileInfo& shipped : QDir(QString::fromStdString(resourcePath("mappings")))
                                        .entryInfoList({"*.toml"}, QDir::Files))
        choice_->addItem(tr("shipped: %1").arg(shipped.fileName()), shipped.filePath());
    choice_->addItem(tr("from a file …"));
    check_ = new QPushButton(tr("&Check"), this);
    setTip(*check_,
           tr("Read the recording by this mapping and list gaps, doubtful units and signs"));
    import_ = new QPushButton(tr("&Import …"), this);
    setTip(*import_, tr("Write a session by this mapping and open it"));
    cancel_ = new QPushButton(tr("Ca&ncel"), this);
    setTip(*cancel_, tr("Stop reading; nothing is written"));
    progress_ = new QProgressBar(this);
    progress_->setAccessibleName(tr("Progress"));
    state_ = new PlainLabel(this);
    state_->setWordWrap(true);

    auto* buttons = new QHBoxLayout;
    buttons->addWidget(choice_);
    buttons->addWidget(check_);
    buttons->addWidget(import_);
    buttons->addWidget(progress_, 1);
    buttons->addWidget(cancel_);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(split, 1);
    layout->addLayout(buttons);
    layout->addWidget(state_);
    layout->addWidget(under(tr("Missing or &doubtful"), result_, this));
    setTabOrder(holds_, mapping_);
    setTabOrder(mapping_, choice_);
    setTabOrder(choice_, check_);
    setTabOrder(check_, import_);
    setTabOrder(import_, cancel_);
    setTabOrder(cancel_, result_);
}

void ImportPage::connectWork()
{
    connect(choice_, &QComboBox::activated, this, &ImportPage::chooseMapping);
    connect(check_, &QPushButton::clicked, this, [this] {
        showBusy(tr("Checking …"));
        work_->check(mapping());
    });
    connect(import_, &QPushButton::clicked, this, &ImportPage::askForSession);
    connect(cancel_, &QPushButton::clicked, work_, &ImportWork::cancel);
    connect(work_, &ImportWork::progressed, this, [this](int percent, quint64 messages) {
        if (!work_->isBusy()) return;
        progress_->setRange(0, percent < 0 ? 0 : 100);
        if (percent >= 0) progress_->setValue(percent);
        state_->setText(tr("%1 messages read").arg(messages));
    });
    connect(
        work_, &ImportWork::surveyed, this, [this](const QString& text, const QString& mapping) {
            holds_->setPlainText(text);
            proposed_ = mapping;
            if (choice_->currentIndex() == 0) mapping_->setPlainText(mapping);
            showIdle(tr(
                "Look at each table of the mapping, above all at signs and units; then check it."));
        });
    connect(work_, &ImportWork::checked, this, [this](const QStringList& doubts) {
        result_->setPlainText(doubts.join(QLatin1Char('\n')));
        showIdle(doubts.isEmpty()
                     ? tr("Nothing is doubtful.")
                     : tr("%n warning(s), see below.", nullptr, static_cast<int>(doubts.size())));
    });
    connect(work_, &ImportWork::imported, this,
            [this](const QString& session, const ImportedSession& report) {
                QStringList remarks;
                for (const std::string& remark : report.remarks)
                    remarks << QString::fromStdString(printable(remark));
                result_->setPlainText(remarks.join(QLatin1Char('\n')));
                showIdle(tr("%1 lines of telemetry in %2 s and %3 scenes written to %4")
                             .arg(report.lines)
                             .arg(format::number(report.seconds, 1))
                             .arg(report.scenes)
                             .arg(format::fileName(session)));
                emit sessionMade(session);
            });
    connect(work_, &ImportWork::failed, this, [this](const QString& why) { showIdle(why); });
    connect(work_, &ImportWork::cancelled, this,
            [this] { showIdle(tr("Cancelled; nothing was written.")); });
}

void ImportPage::chooseMapping(int index)
{
    if (index == 0) return mapping_->setPlainText(proposed_);
    if (index + 1 < choice_->count()) return readMappingFile(choice_->itemData(index).toString());
    askForFile(*this,
               {.title = tr("Mapping"), .filter = tr("Mapping files (*.toml);;All files (*)")},
               [this](const QString& path) { readMappingFile(path); });
}

void ImportPage::readMappingFile(const QString& path)
{
    const auto text = readFile(path.toStdString(), kMaxMappingBytes);
    if (!text) return showIdle(QString::fromStdString(printable(text.error().text)));
    mapping_->setPlainText(QString::fromStdString(printableLines(*text)));
    showIdle(tr("Mapping of %1").arg(format::fileName(path)));
}

void ImportPage::askForSession()
{
    const QString name = QFileInfo(file_).completeBaseName() + QStringLiteral(".tts");
    askForFile(*this,
               {.title = tr("Session to write"),
                .start = QDir(folder_).filePath(name),
                .filter = tr("Sessions (*.tts)"),
                .kind = FileWish::Kind::ToWrite},
               [this](const QString& path) { importInto(path); });
}

void ImportPage::importInto(const QString& session)
{
    showBusy(tr("Importing …"));
    work_->import(mapping(), session.toStdString());
}

void ImportPage::showBusy(const QString& what)
{
    state_->setText(what);
    progress_->setRange(0, 0);
    for (QWidget* const control : std::initializer_list<QWidget*>{check_, import_, choice_})
        control->setEnabled(false);
    cancel_->setEnabled(true);
}

void ImportPage::showIdle(const QString& what)
{
    state_->setText(what);
    progress_->setRange(0, 100);
    progress_->setValue(0);
    for (QWidget* const control : std::initializer_list<QWidget*>{check_, import_, choice_})
        control->setEnabled(true);
    cancel_->setEnabled(false);
}

std::string ImportPage::mapping() const
{
    return mapping_->toPlainText().toStdString();
}

}  // namespace terratact
