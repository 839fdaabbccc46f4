#include "app/review/review_events_page.h"

#include <QAbstractTableModel>
#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/review/review_timeline.h"
#include "core/log/event_text.h"
#include "core/log/review_moment.h"
#include "widgets/base/card.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {

/// The events of a session, of one kind or all, as a table model. Texts are made when a row becomes visible.
class ReviewEvents final : public QAbstractTableModel {
public:
    enum Column { Time, Kind, What, Shown, kColumns };

    ReviewEvents(const SessionReader& session, QObject* parent)
        : QAbstractTableModel(parent), session_(session)
    {
        load(std::nullopt);
    }

    void load(std::optional<EventKind> kind)
    {
        beginResetModel();
        rows_.clear();
        kind_ = kind;
        for (std::size_t i = 0; i < session_.events().size(); ++i)
            if (!kind || session_.events()[i].kind == *kind) rows_.push_back(i);
        endResetModel();
    }
    std::optional<EventKind> kind() const { return kind_; }

    double timeOf(int row) const { return secondsOf(rowOf(row).time); }

    /// Returns the last row up to a time; −1: none.
    int rowAt(SessionTime time) const
    {
        for (int row = rowCount({}) - 1; row >= 0; --row)
            if (rowOf(row).time <= time) return row;
        return -1;
    }

    int rowCount(const QModelIndex& parent) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(rows_.size());
    }
    int columnCount(const QModelIndex& parent) const override
    {
        return parent.isValid() ? 0 : kColumns;
    }
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override
    {
        if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
        switch (section) {
        case Time: return ReviewEventsPage::tr("time");
        case Kind: return ReviewEventsPage::tr("kind");
        case What: return ReviewEventsPage::tr("what");
        case Shown: return ReviewEventsPage::tr("on the screen");
        default: return {};
        }
    }
    QVariant data(const QModelIndex& index, int role) const override
    {
        if (role == Qt::ToolTipRole)  // the column may be too narrow for the text
            return plainTip(data(index, Qt::DisplayRole).toString());
        if (role != Qt::DisplayRole) return {};
        const EventRow& row = rowOf(index.row());
        switch (index.column()) {
        case Time: return timeText(secondsOf(row.time));
        case Kind: return nameOf(row.kind);
        case What: return sentenceOf(row);
        case Shown: return translatedLine(screenOf(row));
        default: return {};
        }
    }

private:
    const EventRow& rowOf(int row) const
    {
        return session_.events()[rows_[static_cast<std::size_t>(row)]];
    }

    const SessionReader& session_;
    std::optional<EventKind> kind_;
    std::vector<std::size_t> rows_;
};

ReviewEventsPage::ReviewEventsPage(const SessionReader& session, QWidget* parent) : Page(parent)
{
    auto* card = new Card(tr("Events of the session"), this);
    alarms_ = new PlainLabel(card);
    alarms_->setWordWrap(true);
    alarms_->setAccessibleName(tr("Active alarms"));
    kinds_ = new QComboBox(card);
    kinds_->setAccessibleName(tr("Kind of the events"));
    setTip(*kinds_, tr("Which events are listed"));
    kinds_->addItem(tr("all kinds"));
    for (int kind = 0; kind < kEventKinds; ++kind)
        kinds_->addItem(nameOf(static_cast<EventKind>(kind)));
    card->titleRow()->addWidget(kinds_);

    events_ = new ReviewEvents(session, this);
    table_ = new QTableView(card);
    table_->setModel(events_);
    table_->setAccessibleName(tr("Events of the session"));
    setTip(*table_, tr("Enter or a double click goes to that time"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    table_->setFrameShape(QFrame::NoFrame);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setHighlightSections(false);
    for (const int wide : {ReviewEvents::What, ReviewEvents::Shown})
        table_->horizontalHeader()->setSectionResizeMode(wide, QHeaderView::Stretch);
    card->body()->addWidget(alarms_);
    card->body()->addWidget(table_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    column->addWidget(card);

    connect(kinds_, &QComboBox::currentIndexChanged, this, [this](int index) {
        events_->load(index > 0 ? std::optional(static_cast<EventKind>(index - 1)) : std::nullopt);
    });
    connect(table_, &QTableView::activated, this,
            [this](const QModelIndex& index) { emit seekWanted(events_->timeOf(index.row())); });
    resizeToFont();
}

void ReviewEventsPage::changeEvent(QEvent* event)
{
    Page::changeEvent(event);
    if (changesFont(*event) && table_) resizeToFont();
}

void ReviewEventsPage::resizeToFont()
{
    kinds_->setMinimumHeight(scaled(kTarget));
    fitRows(*table_, fontMetrics());
    table_->setColumnWidth(ReviewEvents::Time, scaled(130));
    QStringList kinds;
    for (int kind = 0; kind < kEventKinds; ++kind) kinds << nameOf(static_cast<EventKind>(kind));
    table_->setColumnWidth(ReviewEvents::Kind,
                           columnWidthFor(*table_, fontMetrics(), ReviewEvents::Kind, kinds));
}

void ReviewEventsPage::reload()
{
    events_->load(events_->kind());
}

void ReviewEventsPage::setMoment(const ReviewMoment& moment)
{
    QStringList alarms;
    for (const Alarm& alarm : moment.alarms) alarms << translatedLine(alarm.text);
    alarms_->setText(alarms.isEmpty() ? tr("No alarm was active at this time.")
                                      : tr("Alarms at this time: %1").arg(alarms.join("; ")));
    setTone(*alarms_, alarms.isEmpty() ? Tone::Muted : Tone::Bad);
    if (!isVisible() || table_->hasFocus()) return;
    if (const int row = events_->rowAt(moment.time); row >= 0) table_->selectRow(row);
}

}  // namespace terratact
