#include "widgets/signals/raw_trace.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "app/display/format.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/signals/live_rows.h"

namespace terratact {
namespace {

enum TraceColumn { Number, Time, Id, Name, Bytes, Content, kTraceColumns };

QString troubleText(FrameTrouble trouble)
{
    switch (trouble) {
    case FrameTrouble::None: return {};
    case FrameTrouble::Gap: return RawTrace::tr("after a gap");
    case FrameTrouble::WrongChecksum: return RawTrace::tr("wrong checksum");
    case FrameTrouble::WrongSequence: return RawTrace::tr("repeated or out of sequence");
    case FrameTrouble::Other: return RawTrace::tr("not usable");
    case FrameTrouble::Unknown: return RawTrace::tr("not in the DBC");
    }
    return {};
}

}  // namespace

TraceFilter::TraceFilter(const QString& text) : text_(text.trimmed())
{
    bool isHex = false;
    const std::uint32_t id = text_.toUInt(&isHex, 16);
    if (isHex) id_ = id;
}

bool TraceFilter::passes(const CanFrame& frame, const QString& name) const
{
    return text_.isEmpty() || (id_ && frame.id == *id_)
        || name.contains(text_, Qt::CaseInsensitive);
}

/// The rows of RawTrace, newest first.
class TraceModel final : public LiveRows<TracedFrame, kTraceColumns> {
public:
    TraceModel(RawTrace::Words words, QObject* parent) : LiveRows(parent), words_(std::move(words))
    {
    }

    QVariant data(const QModelIndex& index, int role) const override
    {
        if (!index.isValid()) return {};
        const TracedFrame& traced = row(rowCount() - 1 - index.row());
        if (role == Qt::TextAlignmentRole) return alignment(index.column());
        if (role == Qt::ForegroundRole) return colour(traced.trouble);
        if (role == Qt::ToolTipRole)  // the column may be too narrow for the text
            return plainTip(data(index, Qt::DisplayRole).toString());
        if (role != Qt::DisplayRole) return {};
        if (index.column() == Number) return QString::number(traced.number);
        if (index.column() == Time) return format::number(traced.time, 3);
        const TraceText words = words_(traced.frame);
        switch (index.column()) {
        case Id: return words.id;
        case Name: return traced.echo ? RawTrace::tr("%1 (from here)").arg(words.name) : words.name;
        case Bytes: return words.bytes;
        default: return said(words.content, troubleText(traced.trouble));
        }
    }

private:
    static QString said(const QString& content, const QString& trouble)
    {
        if (trouble.isEmpty()) return content;
        return content.isEmpty() ? QStringLiteral("✘ ") + trouble
                                 : QStringLiteral("✘ %1: %2").arg(trouble, content);
    }
    QString heading(int column) const override
    {
        const QString names[kTraceColumns]{RawTrace::tr("Number"), RawTrace::tr("Time [s]"),
                                           RawTrace::tr("Id"),     RawTrace::tr("Frame"),
                                           RawTrace::tr("Bytes"),  RawTrace::tr("Content")};
        return names[column];
    }
    bool isNumber(int column) const override { return column <= Time; }
    static QColor colour(FrameTrouble trouble)
    {
        if (trouble == FrameTrouble::None) return theme().text;
        return trouble == FrameTrouble::Unknown ? theme().muted : theme().bad;
    }

    RawTrace::Words words_;
};

RawTrace::RawTrace(Words words, Name name, QWidget* parent)
    : QWidget(parent), name_(std::move(name)), model_(new TraceModel(std::move(words), this))
{
    filter_ = new QLineEdit(this);
    filter_->setPlaceholderText(tr("id (hexadecimal) or a part of the name"));
    filter_->setAccessibleName(tr("Filter of the frames"));
    filter_->setClearButtonEnabled(true);
    pause_ = new QPushButton(tr("Pause display"), this);
    pause_->setCheckable(true);
    pause_->setFocusPolicy(Qt::TabFocus);
    setTip(*pause_, tr("Display paused; recording and counting continue"));
    summary_ = new PlainLabel(this);
    setTone(*summary_, Tone::Muted);

    view_ = new PlainTable(this);
    view_->setAccessibleName(tr("Newest frames"));
    view_->setModel(model_);
    view_->setWidest({{QStringLiteral("123456789")},
                      {QStringLiteral("1234567.890")},
                      {QStringLiteral("1FFFFFFF FD")},
                      {tr("%1 (from here)").arg(QStringLiteral("ConsoleHeartbeat"))},
                      {QStringLiteral("[8] DD DD DD DD DD DD DD DD")},
                      {}});

    auto* controls = new QHBoxLayout;
    controls->setSpacing(10);
    controls->addWidget(filter_);
    controls->addWidget(pause_);
    controls->addWidget(summary_);
    controls->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addLayout(controls);
    column->addWidget(view_, 1);
    connect(filter_, &QLineEdit::textChanged, this, &RawTrace::applyFilter);
    connect(pause_, &QPushButton::toggled, this, [this](bool held) {
        pause_->setText(held ? tr("Paused: continue") : tr("Pause display"));
    });
    resizeToFont();
}

void RawTrace::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (changesFont(*event) && filter_) resizeToFont();
}

void RawTrace::resizeToFont()
{
    filter_->setFixedWidth(scaled(320));
    filter_->setMinimumHeight(scaled(kTarget));
    pause_->setMinimumHeight(scaled(kTarget));
}

void RawTrace::setFrames(std::vector<TracedFrame> frames)
{
    if (isPaused()) return;
    frames_ = std::move(frames);
    applyFilter();
}

void RawTrace::applyFilter()
{
    const TraceFilter filter(filter_->text());
    std::vector<TracedFrame> passed;
    for (const TracedFrame& traced : frames_)
        if (filter.passes(traced.frame, name_(traced.frame))) passed.push_back(traced);
    summary_->setText(tr("%1 of the newest %2 frames").arg(passed.size()).arg(frames_.size()));
    model_->setRows(std::move(passed));
}

bool RawTrace::isPaused() const
{
    return pause_->isChecked();
}

QString RawTrace::summary() const
{
    return summary_->text();
}

}  // namespace terratact
