#include "widgets/signals/signal_list.h"

#include <QApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <functional>
#include <utility>

#include "widgets/base/palette.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr int kKeyRole = Qt::UserRole;

/// A list whose items can be dragged over the window.
class DraggedList final : public QListWidget {
public:
    struct Calls {
        std::function<void(const QString&, const QPoint&)> moved, dropped;
        std::function<void()> ended;
    };
    DraggedList(Calls calls, QWidget* parent) : QListWidget(parent), calls_(std::move(calls)) {}

protected:
    void mousePressEvent(QMouseEvent* event) override
    {
        QListWidget::mousePressEvent(event);
        const QListWidgetItem* item = itemAt(event->position().toPoint());
        pressedAt_ = event->position().toPoint();
        key_ =
            item && event->button() == Qt::LeftButton ? item->data(kKeyRole).toString() : QString();
        drags_ = false;
    }
    void mouseMoveEvent(QMouseEvent* event) override
    {
        if (key_.isEmpty()) return;
        const QPoint way = event->position().toPoint() - pressedAt_;
        if (!drags_ && way.manhattanLength() < QApplication::startDragDistance()) return;
        if (!drags_) viewport()->setCursor(Qt::ClosedHandCursor);
        drags_ = true;
        calls_.moved(key_, event->globalPosition().toPoint());
    }
    void mouseReleaseEvent(QMouseEvent* event) override
    {
        QListWidget::mouseReleaseEvent(event);
        if (drags_) calls_.dropped(key_, event->globalPosition().toPoint());
        end();
    }
    void hideEvent(QHideEvent* event) override
    {
        QListWidget::hideEvent(event);
        end();
    }

private:
    void end()
    {
        if (drags_) {
            viewport()->unsetCursor();
            calls_.ended();
        }
        drags_ = false;
        key_.clear();
    }

    Calls calls_;
    QPoint pressedAt_;
    QString key_;
    bool drags_ = false;
};

}  // namespace

SignalList::SignalList(QWidget* parent) : QWidget(parent)
{
    filter_ = new QLineEdit(this);
    filter_->setPlaceholderText(tr("part of a name"));
    filter_->setAccessibleName(tr("Filter of the signals"));
    filter_->setClearButtonEnabled(true);
    filter_->setMinimumHeight(kTarget);
    list_ =
        new DraggedList({[this](const QString& key, const QPoint& at) { emit dragged(key, at); },
                         [this](const QString& key, const QPoint& at) { emit dropped(key, at); },
                         [this] { emit dragEnded(); }},
                        this);
    list_->setAccessibleName(tr("Signals to plot"));
    list_->setUniformItemSizes(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setTextElideMode(Qt::ElideRight);
    setTip(*list_, tr("Drag a signal onto a plot, or below the last one for a new plot"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(filter_);
    column->addWidget(list_, 1);
    connect(filter_, &QLineEdit::textChanged, this, &SignalList::applyFilter);
    connect(list_, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { emit wanted(item->data(kKeyRole).toString()); });
}

void SignalList::setSignals(const QList<ListedSignal>& all)
{
    if (all == all_) return;
    const bool sameKeys =
        all.size() == all_.size()
        && std::equal(all.begin(), all.end(), all_.begin(),
                      [](const ListedSignal& a, const ListedSignal& b) { return a.key == b.key; });
    const QString kept = chosenKey();
    all_ = all;
    if (!sameKeys) {
        list_->clear();
        for (const ListedSignal& signal : all_) {
            auto* item = new QListWidgetItem(list_);
            item->setData(kKeyRole, signal.key);
        }
    }
    for (int i = 0; i < list_->count(); ++i) {
        const ListedSignal& signal = all_[i];
        list_->item(i)->setText(signal.isPlotted ? QStringLiteral("✓ ") + signal.text
                                                 : signal.text);
        list_->item(i)->setData(Qt::ToolTipRole, plainTip(signal.text));
    }
    if (!sameKeys) choose(kept);
    applyFilter();
}

void SignalList::applyFilter()
{
    const QStringList parts =
        filter_->text().simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (int i = 0; i < list_->count(); ++i) {
        const bool passes = std::all_of(parts.begin(), parts.end(), [&](const QString& part) {
            return all_[i].text.contains(part, Qt::CaseInsensitive);
        });
        list_->item(i)->setHidden(!passes);
    }
}

QString SignalList::chosenKey() const
{
    const QListWidgetItem* item = list_->currentItem();
    return item && !item->isHidden() ? item->data(kKeyRole).toString() : QString();
}

void SignalList::choose(const QString& key)
{
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->data(kKeyRole).toString() == key) return list_->setCurrentRow(i);
}

}  // namespace terratact
