#include "app/review/export/review_export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "app/display/format.h"
#include "app/review/export/review_export_choices.h"
#include "app/shell/file_dialog.h"
#include "app/shell/new_file.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/signals/session_timeline.h"

namespace terratact {
namespace {

constexpr int kRefreshPeriod = 200;  // [ms]
constexpr int kPathWide = 420;       // [px] at 100 %

const ExportChoice& chosen(const QComboBox& what)
{
    return exportChoices().at(static_cast<std::size_t>(what.currentIndex()));
}

/// Returns a format's name for its file ending, with the programs that read it.
QString formatName(const QString& ending)
{
    if (ending == QLatin1String("log")) return ReviewExportDialog::tr(".log, candump");
    if (ending == QLatin1String("asc")) return ReviewExportDialog::tr(".asc, Vector");
    if (ending == QLatin1String("mcap")) return ReviewExportDialog::tr(".mcap, Foxglove");
    return QLatin1Char('.') + ending;
}

/// Returns true if the export can include signals of DBC files, like session export --dbc.
bool holdsSignals(const ExportChoice& choice)
{
    return choice.from == ExportSource::Rows
        && (!choice.rows || *choice.rows == ExportKind::Signals);
}

QString spanText(double first, double last)
{
    return ReviewExportDialog::tr("%1 to %2").arg(timeText(first), timeText(last));
}

/// Returns a default path without ending in the documents folder. The name states content and time, so that two exports
/// differ.
QString startFile(const QString& session, const ExportChoice& choice,
                  const ExportViewState& viewState)
{
    const auto seconds = [](double s) { return QString::number(s, 'f', 1); };
    // Shortens a long session name, so that the whole name stays a valid file name.
    QString name = format::fileName(QFileInfo(session).completeBaseName()) + QLatin1Char('-')
                 + QLatin1String(choice.part);
    if (choice.from == ExportSource::Report)
        name += QStringLiteral("-scene%1").arg(viewState.scene);
    else if (choice.from == ExportSource::Picture || choice.from == ExportSource::Numbers)
        name += QStringLiteral("-%1s").arg(seconds(viewState.now));
    return documentsFolder() + QLatin1Char('/') + name;
}

}  // namespace

ReviewExportDialog::ReviewExportDialog(Sources sources, QWidget* parent)
    : QDialog(parent), sources_(std::move(sources))
{
    setWindowTitle(tr("Export — %1").arg(format::fileName(sources_.session)));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 14);
    column->setSpacing(10);
    column->addWidget(form());
    progress_ = new QProgressBar(this);
    progress_->setRange(0, 100);
    progress_->setAccessibleName(tr("Progress of the export"));
    column->addWidget(progress_);
    result_ = new PlainLabel(this);
    result_->setWordWrap(true);
    result_->setAccessibleName(tr("Result of the export"));
    result_->setMinimumHeight(scaled(44));
    result_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    column->addWidget(result_);
    column->addStretch(1);
    column->addWidget(buttons());
    offerFormats();
    connect(path_, &QLineEdit::textChanged, this, &ReviewExportDialog::showButtons);
    // The result is that of the export as it was chosen.
    connect(path_, &QLineEdit::textChanged, result_, &QLabel::clear);
    connect(what_, &QComboBox::currentIndexChanged, result_, &QLabel::clear);
    connect(format_, &QComboBox::currentIndexChanged, result_, &QLabel::clear);
    for (const QAbstractButton* choice :
         std::initializer_list<QAbstractButton*>{visible_, everything_, payload_})
        connect(choice, &QAbstractButton::toggled, result_, &QLabel::clear);
    connect(&pollTimer_, &QTimer::timeout, this, &ReviewExportDialog::showViewState);
}

ReviewExportDialog::~ReviewExportDialog() = default;

QWidget* ReviewExportDialog::form()
{
    auto* form = new QWidget(this);
    auto* rows = new QFormLayout(form);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    const auto combo = [&](const QString& name, const QString& tip) {
        auto* box = new QComboBox(form);
        box->setMinimumHeight(scaled(kTarget));
        box->setAccessibleName(name);
        setTip(*box, tip);
        addField(*rows, name, box);
        return box;
    };
    what_ = combo(tr("What"), tr("Part of the session to export"));
    for (const ExportChoice& choice : exportChoices())
        what_->addItem(QCoreApplication::translate("ReviewExport", choice.name));
    format_ = combo(tr("Format"), tr("Which programs can read it"));
    addField(*rows, tr("Of"), span());
    payload_ = new QCheckBox(form);
    payload_->setMinimumHeight(scaled(kTarget));
    connect(payload_, &QCheckBox::clicked, this, [this](bool wanted) { payloadWanted_ = wanted; });
    addField(*rows, tr("Other devices"), payload_);
    addField(*rows, tr("File"), file());
    connect(what_, &QComboBox::currentIndexChanged, this, &ReviewExportDialog::offerFormats);
    connect(format_, &QComboBox::currentIndexChanged, this, &ReviewExportDialog::applyFormat);
    return form;
}

QWidget* ReviewExportDialog::span()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    visible_ = new QRadioButton(box);
    visible_->setChecked(true);
    everything_ = new QRadioButton(box);
    moment_ = new PlainLabel(box);
    for (QWidget* const line : std::initializer_list<QWidget*>{visible_, everything_, moment_}) {
        line->setMinimumHeight(scaled(kTarget));
        column->addWidget(line);
    }
    column->addStretch(1);
    box->setMinimumHeight(scaled(2 * kTarget + 4));  // both variants have this height
    return box;
}

QWidget* ReviewExportDialog::file()
{
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    path_ = new QLineEdit(row);
    path_->setMinimumSize(scaled(kPathWide), scaled(kTarget));
    path_->setAccessibleName(tr("File"));
    setTip(*path_, tr("Where it is written"));
    browse_ = new QPushButton(tr("Choose …"), row);
    line->addWidget(path_, 1);
    line->addWidget(browse_);
    connect(browse_, &QPushButton::clicked, this, &ReviewExportDialog::browse);
    return row;
}

QWidget* ReviewExportDialog::buttons()
{
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    export_ = new QPushButton(row);
    export_->setProperty("role", "primary");
    export_->setDefault(true);
    cancel_ = new QPushButton(tr("Cancel"), row);
    auto* close = new QPushButton(tr("Close"), row);
    close->setAutoDefault(false);
    line->addStretch(1);
    for (QPushButton* const button : {export_, cancel_, close}) {
        button->setMinimumHeight(scaled(kTarget));
        line->addWidget(button);
    }
    connect(export_, &QPushButton::clicked, this, &ReviewExportDialog::write);
    connect(cancel_, &QPushButton::clicked, this, [this] {
        if (job_) job_->cancel();
    });
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    return row;
}

void ReviewExportDialog::ask()
{
    if (!job_) {
        result_->clear();
        wanted_.clear();
    }
    showViewState();
    pollTimer_.start(kRefreshPeriod);
    show();
    raise();
    activateWindow();
}

void ReviewExportDialog::offerFormats()
{
    {
        const QSignalBlocker quiet(format_);
        format_->clear();
        for (const QString& ending : chosen(*what_).formats)
            format_->addItem(formatName(ending), ending);
    }
    applyFormat();
    showViewState();
}

/// Proposes a file name, unless the operator has typed one.
void ReviewExportDialog::nameFile()
{
    if (job_ || path_->text() != named_) return;
    const QString wanted = startFile(sources_.session, chosen(*what_), viewState_)
                         + QLatin1Char('.') + format_->currentData().toString();
    if (wanted == wanted_) return;  // the file of the last export keeps its name
    wanted_ = wanted;
    named_ = newFile(wanted);
    path_->setText(named_);
}

void ReviewExportDialog::applyFormat()
{
    if (path_->text() == named_) return nameFile();
    const QFileInfo named(path_->text());
    path_->setText(named.path() + QLatin1Char('/') + named.completeBaseName() + QLatin1Char('.')
                   + format_->currentData().toString());
}

QString ReviewExportDialog::path() const
{
    const QString text = path_->text().trimmed(), ending = format_->currentData().toString();
    const bool hasIt = QFileInfo(text).suffix().compare(ending, Qt::CaseInsensitive) == 0;
    return hasIt ? text : text + QLatin1Char('.') + ending;
}

void ReviewExportDialog::showViewState()
{
    if (job_) return;
    viewState_ = sources_.poll();
    const bool all = viewState_.first <= viewState_.begin && viewState_.last >= viewState_.end;
    const QString visible = viewState_.isCursors ? tr("from A to B, %1")
                          : all                  ? tr("what is visible: all, %1")
                                                 : tr("what is visible, %1");
    visible_->setText(visible.arg(spanText(viewState_.first, viewState_.last)));
    everything_->setText(tr("everything, %1").arg(spanText(viewState_.begin, viewState_.end)));
    const ExportSource from = chosen(*what_).from;
    moment_->setText(
        from == ExportSource::Mission || from == ExportSource::Strip
            ? tr("the whole session, %1").arg(spanText(viewState_.begin, viewState_.end))
        : from != ExportSource::Report ? tr("this time, %1").arg(timeText(viewState_.now))
        : viewState_.scene > 0         ? tr("scene %1").arg(viewState_.scene)
                                       : tr("there is no estimate at this time"));
    moment_->setVisible(from != ExportSource::Rows);
    showPayload();
    nameFile();
    visible_->setVisible(from == ExportSource::Rows);
    everything_->setVisible(from == ExportSource::Rows);
    showButtons();
}

void ReviewExportDialog::showPayload()
{
    QStringList names;
    for (const QString& file : sources_.dbc()) names << format::fileName(file);
    const bool holds = holdsSignals(chosen(*what_));
    const QString with = tr("with the signals of %1").arg(names.join(QStringLiteral(", ")));
    const QString seen =
        payload_->fontMetrics().elidedText(with, Qt::ElideRight, scaled(kPathWide));
    payload_->setText(names.isEmpty()
                          ? tr("no DBC file describes them")
                          : QString(seen).replace(QLatin1Char('&'), QStringLiteral("&&")));
    payload_->setChecked(!names.isEmpty() && holds && payloadWanted_);
    payload_->setEnabled(!names.isEmpty() && !job_ && holds);
    setTip(*payload_, names.isEmpty() ? tr("The page Signals (F7) adds DBC files")
                      : holds         ? names.join(QLatin1Char('\n'))
                                      : tr("Only the kind Signals holds the values of DBC files"));
}

std::optional<QString> ReviewExportDialog::whyNotExport() const
{
    if (job_) return tr("A file is being written");
    if (chosen(*what_).from == ExportSource::Report && viewState_.scene == 0)
        return tr("There is no estimate at this time");
    if (path_->text().trimmed().isEmpty()) return tr("Name the file first");
    return std::nullopt;
}

void ReviewExportDialog::showButtons()
{
    const auto whyNot = whyNotExport();
    export_->setText(QFileInfo::exists(path()) ? tr("Replace the file") : tr("Export"));
    export_->setEnabled(!whyNot);
    setTip(*export_, whyNot.value_or(tr("Writes the file")));
    for (QWidget* const choice :
         std::initializer_list<QWidget*>{what_, format_, visible_, everything_, path_, browse_})
        choice->setEnabled(!job_);
    setTip(*browse_, job_ ? *whyNot : tr("Choose the file"));
    setTip(*visible_,
           job_ ? *whyNot
                : tr("From A to B, else the visible part of the timeline: zoom with Z and X"));
    setTip(*everything_, job_ ? *whyNot : tr("The whole session"));
    cancel_->setEnabled(job_ != nullptr);
    setTip(*cancel_, job_ ? tr("Cancels the export and leaves no file (Esc)")
                          : tr("Nothing is being written"));
    progress_->setVisible(job_ != nullptr);
}

void ReviewExportDialog::browse()
{
    const QString ending = format_->currentData().toString();
    const FileWish wish{.title = tr("Export to"),
                        .start = path(),
                        .filter = QStringLiteral("%1 (*.%2)").arg(format_->currentText(), ending),
                        .kind = FileWish::Kind::ToWrite};
    askForFile(*this, wish, [this](const QString& file) {
        path_->setText(file);
        path_->setText(path());
    });
}

void ReviewExportDialog::write()
{
    const ExportChoice& choice = chosen(*what_);
    to_ = path();
    path_->setText(to_);
    switch (choice.from) {
    case ExportSource::Picture: return wrote(sources_.savePicture(to_));
    case ExportSource::Numbers: return wrote(sources_.saveNumbers(to_));
    case ExportSource::Report:
    case ExportSource::Mission:
    case ExportSource::Strip:
    case ExportSource::Rows: break;
    }
    SessionExportJob::Wish wish{.session = sources_.session.toStdString(),
                                .out = to_.toStdString(),
                                .strip = choice.from == ExportSource::Strip};
    if (choice.from == ExportSource::Report) {
        wish.scene = viewState_.scene;
    } else if (choice.from == ExportSource::Rows) {
        wish.format = exportFormatOf(wish.out);
        wish.selection.what = choice.rows;
        if (holdsSignals(choice) && payload_->isChecked())
            for (const QString& dbc : sources_.dbc()) wish.dbc.push_back(dbc.toStdString());
        if (visible_->isChecked()) {
            wish.selection.from = viewState_.first;
            wish.selection.to = viewState_.last;
        }
    }
    begin(std::move(wish));
}

void ReviewExportDialog::begin(SessionExportJob::Wish wish)
{
    progress_->setValue(0);
    result_->clear();
    job_ = std::make_unique<SessionExportJob>(std::move(wish));
    connect(job_.get(), &SessionExportJob::progressed, progress_,
            [this](double share) { progress_->setValue(static_cast<int>(100.0 * share)); });
    connect(job_.get(), &SessionExportJob::ended, this, &ReviewExportDialog::wrote);
    job_->start();
    showButtons();
    cancel_->setFocus();
}

void ReviewExportDialog::wrote(const QString& trouble, qulonglong leftOut, int damaged,
                               int withoutColumns)
{
    const bool cancelled = job_ && job_->cancelled() && !trouble.isEmpty();
    job_.reset();
    QStringList parts;
    if (cancelled)
        parts << tr("Cancelled: no file was written");
    else if (!trouble.isEmpty())
        parts << tr("NOT WRITTEN: %1").arg(trouble);
    else
        parts << tr("Written: %1").arg(to_);
    if (leftOut > 0)
        parts << tr("frames left out because the format cannot hold them: %1").arg(leftOut);
    if (damaged > 0) parts << tr("damaged and left out, places: %1").arg(damaged);
    if (withoutColumns > 0)
        parts << tr("messages of DBC files left out for lack of room: %1").arg(withoutColumns);
    showViewState();
    result_->setText(parts.join(QStringLiteral(" · ")));
    setTone(*result_, !trouble.isEmpty()                                 ? Tone::Bad
                      : leftOut > 0 || damaged > 0 || withoutColumns > 0 ? Tone::Warning
                                                                         : Tone::Good);
    showButtons();
    export_->setFocus();
}

void ReviewExportDialog::reject()
{
    if (job_) return job_->cancel();
    pollTimer_.stop();
    QDialog::reject();
}

}  // namespace terratact
