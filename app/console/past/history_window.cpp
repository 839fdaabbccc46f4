#include "app/console/past/history_window.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/console/past/past_text.h"
#include "app/mission/estimate_history.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/terrain/readings/terrain_thumbnail.h"

namespace terratact {
namespace {

constexpr QSize kThumbnail{150, 76};  // [px] at 100 %

QIcon thumbnailOf(const TwoTrackEstimate& estimate, qreal ratio)
{
    const QSize size{scaled(kThumbnail.width()), scaled(kThumbnail.height())};
    QPixmap picture(size * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    drawTerrainThumbnail(painter, QRectF(QPointF(), QSizeF(size)), estimate);
    painter.end();
    // A selected or disabled icon would be tinted.
    QIcon icon;
    for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected, QIcon::Active})
        icon.addPixmap(picture, mode);
    return icon;
}

}  // namespace

HistoryWindow::HistoryWindow(const EstimateHistory& history, QWidget* parent)
    : QWidget(parent, Qt::Dialog), history_(history), state_(new PlainLabel(this)),
      list_(new QListWidget(this)), lay_(new QPushButton(this)),
      present_(new QPushButton(tr("Present estimate (Backspace)"), this)),
      restore_(new QPushButton(tr("Restore (Ctrl+Z)"), this))
{
    setObjectName(QStringLiteral("estimate-history"));
    setWindowTitle(tr("Estimates of this run"));
    state_->setWordWrap(true);
    list_->setAccessibleName(tr("Estimates, newest first"));
    list_->setWordWrap(true);
    list_->setUniformItemSizes(false);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTip(*present_, tr("The picture shows the present estimate again"));
    setTip(*restore_, tr("Brings the hidden estimate back while the robot has not moved"));
    auto* row = new QHBoxLayout;
    for (QPushButton* button : {lay_, present_, restore_}) row->addWidget(button, 1);
    auto* column = new QVBoxLayout(this);
    column->addWidget(state_);
    column->addWidget(list_, 1);
    column->addLayout(row);
    // Not currentItemChanged: a list that gets the focus makes its first row current by itself.
    connect(list_, &QListWidget::itemSelectionChanged, this, [this] {
        if (const std::int64_t number = chosen()) emit showWanted(number);
    });
    connect(lay_, &QPushButton::clicked, this,
            [this] { emit layWanted(laid_ != 0 ? 0 : chosen()); });
    connect(present_, &QPushButton::clicked, this, &HistoryWindow::presentWanted);
    connect(restore_, &QPushButton::clicked, this, &HistoryWindow::restoreWanted);
    connect(&history_, &EstimateHistory::changed, this, [this] {
        if (isVisible()) fill();
    });
    list_->installEventFilter(this);
    setFocusProxy(list_);
}

std::int64_t HistoryWindow::chosen() const
{
    const QList<QListWidgetItem*> items = list_->selectedItems();
    return items.isEmpty() ? 0 : items.first()->data(Qt::UserRole).toLongLong();
}

void HistoryWindow::setShown(std::int64_t shown, std::int64_t laid, bool canRestore)
{
    if (shown == shown_ && laid == laid_ && canRestore == canRestore_) return;
    if (shown == 0 && shown_ != 0) {
        const QSignalBlocker quiet(list_);
        list_->setCurrentItem(nullptr);
        list_->clearSelection();
    }
    shown_ = shown;
    laid_ = laid;
    canRestore_ = canRestore;
    if (isVisible()) showState();
}

void HistoryWindow::fill()
{
    const QSignalBlocker quiet(list_);
    const std::int64_t before = chosen();
    list_->clear();
    list_->setIconSize({scaled(kThumbnail.width()), scaled(kThumbnail.height())});
    const std::int64_t present = history_.present();
    for (const PastEstimate& past : history_.entries()) {
        QString head = tr("%1 · number %2").arg(PastText::time(past)).arg(past.number);
        if (past.number == present) head += QStringLiteral(" · ") + tr("present");
        if (past.isHidden) head += QStringLiteral(" · ") + tr("hidden by the operator");
        if (past.isRestored) head += QStringLiteral(" · ") + tr("restored, from before");
        auto* item = new QListWidgetItem(thumbnailOf(*past.estimate, devicePixelRatioF()),
                                         QStringList{head, PastText::verdict(past),
                                                     PastText::origin(past), PastText::error(past)}
                                             .join(QLatin1Char('\n')),
                                         list_);
        item->setData(Qt::UserRole, static_cast<qlonglong>(past.number));
        if (past.number == before) list_->setCurrentItem(item);
    }
    showState();
}

void HistoryWindow::showState()
{
    const PastEstimate* const shown = history_.entry(shown_);
    const PastEstimate* const laid = history_.entry(laid_);
    QString text = history_.entries().empty()
                     ? tr("No estimate yet. The last %1 of this run are kept.")
                           .arg(EstimateHistory::kMaxKept)
                 : shown ? PastText::note(*shown)
                 : laid  ? tr("The estimate of %1 lies over the present one, in the robot's frame "
                               "of that time.")
                              .arg(PastText::time(*laid))
                        : tr("The picture shows the present. Choose an estimate to see it; the "
                             "verdict stays that of the present.");
    state_->setText(text);
    setTone(*state_, shown ? Tone::Warning : Tone::Muted);
    lay_->setText(laid_ != 0 ? tr("Take it away (L)") : tr("Lay over the present (L)"));
    lay_->setEnabled(laid_ != 0 || chosen() != 0);
    setTip(*lay_, lay_->isEnabled() ? tr("Draws it as a lighter profile over the present one")
                                    : tr("Choose an estimate first"));
    present_->setEnabled(shown_ != 0 || laid_ != 0);
    restore_->setEnabled(canRestore_);
}

/// Obeys a key of this window. Returns false if it has no meaning.
bool HistoryWindow::act(const QKeyEvent& event)
{
    const bool plain = event.modifiers() == Qt::NoModifier;
    if (event.matches(QKeySequence::Undo))
        emit restoreWanted();
    else if (plain && event.key() == Qt::Key_Escape)
        close();
    else if (plain && event.key() == Qt::Key_Backspace)
        present_->click();
    else if (plain && event.key() == Qt::Key_L)
        lay_->click();
    else
        return false;
    return true;
}

/// Chooses the row that has the focus, if none is chosen: an arrow key would pass it over.
bool HistoryWindow::chooseFirst(const QKeyEvent& event)
{
    const bool isArrow = event.key() == Qt::Key_Up || event.key() == Qt::Key_Down;
    if (!isArrow || event.modifiers() != Qt::NoModifier || chosen() != 0 || list_->count() == 0)
        return false;
    list_->setCurrentRow(std::max(list_->currentRow(), 0));
    return true;
}

void HistoryWindow::keyPressEvent(QKeyEvent* event)
{
    if (!act(*event)) QWidget::keyPressEvent(event);
}

/// The list would search for a row that begins with the letter.
bool HistoryWindow::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (act(key) || chooseFirst(key)) return true;
    }
    return QWidget::eventFilter(object, event);
}

void HistoryWindow::showEvent(QShowEvent* event)
{
    fill();
    QWidget::showEvent(event);
}

void HistoryWindow::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange && isVisible()) fill();
}

}  // namespace terratact
