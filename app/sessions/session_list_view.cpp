#include "app/sessions/session_list_view.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QStyledItemDelegate>

#include "app/sessions/session_list.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/readings/terrain_thumbnail.h"

namespace terratact {
namespace {

constexpr int kMaxSpans = 1000;
constexpr int kGroundWide = 84, kGroundHigh = 34;  // [px] at 100 %

/// Paints the last estimate's terrain.
class GroundCell final : public QStyledItemDelegate {
public:
    GroundCell(const SearchedSessions& sessions, QObject* parent)
        : QStyledItemDelegate(parent), sessions_(sessions)
    {
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        QStyledItemDelegate::paint(painter, option, index);  // selection and focus
        const ListedSession& session = sessions_.at(index.row());
        if (!session.summary || !session.summary->last) return;
        drawTerrainThumbnail(*painter, QRectF(option.rect).adjusted(3, 2, -3, -2),
                             session.summary->last->estimate);
    }

private:
    const SearchedSessions& sessions_;
};

/// Keeps right-aligned texts off the next column.
class PaddedCell final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QString displayText(const QVariant& value, const QLocale& locale) const override
    {
        const QString text = QStyledItemDelegate::displayText(value, locale);
        return text.isEmpty() ? text : text + QString(2, QChar(QChar::Nbsp));
    }
};

}  // namespace

SessionListView::SessionListView(SearchedSessions& sessions, QWidget* parent)
    : QTableView(parent), sessions_(sessions)
{
    setModel(&sessions);
    setItemDelegate(new PaddedCell(this));
    setItemDelegateForColumn(SessionList::Ground, new GroundCell(sessions, this));
    span_.setSingleShot(true);
    connect(&span_, &QTimer::timeout, this, &SessionListView::spanReasons);
    connect(&sessions, &QAbstractItemModel::modelReset, this, &SessionListView::spanSoon);
    connect(&sessions, &QAbstractItemModel::layoutChanged, this, &SessionListView::spanSoon);
    connect(&sessions, &QAbstractItemModel::rowsInserted, this, &SessionListView::spanSoon);
    connect(&sessions, &QAbstractItemModel::rowsRemoved, this, &SessionListView::spanSoon);
    setAccessibleName(tr("Recordings"));
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setShowGrid(false);
    setAlternatingRowColors(true);
    setWordWrap(false);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionResizeMode(SessionList::Notes, QHeaderView::Stretch);
    horizontalHeader()->setMinimumSectionSize(scaled(40));
    horizontalHeader()->setSortIndicator(SessionList::Begins, Qt::DescendingOrder);
    setSortingEnabled(true);
    resizeToFont();
}

void SessionListView::sortBy(int column)
{
    const QHeaderView& header = *horizontalHeader();
    const bool isSorted = header.sortIndicatorSection() == column;
    const bool isText = column == SessionList::Robot || column == SessionList::State;
    const Qt::SortOrder first = isText ? Qt::AscendingOrder : Qt::DescendingOrder;
    const bool descends = header.sortIndicatorOrder() == Qt::DescendingOrder;
    sortByColumn(column, !isSorted ? first : descends ? Qt::AscendingOrder : Qt::DescendingOrder);
    if (currentIndex().isValid()) scrollTo(currentIndex());
}

void SessionListView::spanSoon()
{
    span_.start(0);  // once for several changes
}

void SessionListView::spanReasons()
{
    clearSpans();
    int spans = 0;
    for (int row = 0; row < sessions_.rowCount() && spans < kMaxSpans; ++row) {
        if (sessions_.at(row).trouble.empty()) continue;
        setSpan(row, SessionList::Robot, 1, SessionList::Notes - SessionList::Robot + 1);
        ++spans;
    }
}

void SessionListView::changeEvent(QEvent* event)
{
    QTableView::changeEvent(event);
    if (changesFont(*event)) resizeToFont();
}

void SessionListView::keyPressEvent(QKeyEvent* event)
{
    const int digit = event->key() - Qt::Key_0;
    if (event->modifiers() != Qt::AltModifier || digit < 0 || digit > 9)
        return QTableView::keyPressEvent(event);
    sortBy(digit == 0 ? SessionList::kColumns - 1 : digit - 1);
}

void SessionListView::resizeToFont()
{
    fitRows(*this, fontMetrics());
    const int high = std::max(scaled(kGroundHigh), verticalHeader()->defaultSectionSize());
    verticalHeader()->setDefaultSectionSize(high);
    setColumnWidth(SessionList::Ground, scaled(kGroundWide));
    const auto fit = [this](int column, const QStringList& texts) {
        setColumnWidth(column, columnWidthFor(*this, fontMetrics(), column, texts));
    };
    fit(SessionList::Begins, {QStringLiteral("≤ 2026-10-26 14:13")});
    fit(SessionList::Robot, {QStringLiteral("Absolem 2")});
    fit(SessionList::Lasts, {QStringLiteral("10:00:00")});
    fit(SessionList::Verdicts, {QStringLiteral("1 CLEAR · 1 CANNOT TELL")});
    fit(SessionList::Probes, {QStringLiteral("100")});
    fit(SessionList::Alarms, {QStringLiteral("100")});
    fit(SessionList::Size, {SessionList::tr("%1 MB").arg(QStringLiteral("1000.0"))});
    fit(SessionList::State, {SessionList::tr("● being recorded"),
                             SessionList::tr("✕ cannot be read"), SessionList::tr("○ not closed")});
}

}  // namespace terratact
