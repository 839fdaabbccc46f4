#include "widgets/base/scroll_column.h"

#include <QEvent>
#include <QScrollBar>
#include <QVBoxLayout>

namespace terratact {

ScrollColumn::ScrollColumn(int leastLines, QWidget* parent)
    : QScrollArea(parent), leastLines_(leastLines)
{
    setObjectName(QStringLiteral("scrollColumn"));
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidgetResizable(true);
    auto* inside = new QWidget(this);
    column_ = new QVBoxLayout(inside);
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(1);
    setWidget(inside);
    for (QWidget* ground : {inside, viewport()}) ground->setAutoFillBackground(false);
    connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, &ScrollColumn::settle);
}

void ScrollColumn::setLeastLines(int lines)
{
    if (lines == leastLines_) return;
    leastLines_ = lines;
    updateGeometry();
}

bool ScrollColumn::isScrolled() const
{
    return verticalScrollBar()->maximum() > 0;
}

void ScrollColumn::settle()
{
    setFocusPolicy(isScrolled() ? Qt::TabFocus : Qt::NoFocus);
}

QSize ScrollColumn::sizeHint() const
{
    const int frame = 2 * frameWidth();
    const int width = viewport()->width();
    const int height = column_->hasHeightForWidth() && width > 0
                         ? column_->totalHeightForWidth(width)
                         : column_->totalSizeHint().height();
    return {column_->totalSizeHint().width() + frame, height + frame};
}

QSize ScrollColumn::minimumSizeHint() const
{
    const int frame = 2 * frameWidth();
    return {column_->totalMinimumSize().width() + frame,
            leastLines_ * (fontMetrics().lineSpacing() + column_->spacing()) + 2 + frame};
}

bool ScrollColumn::eventFilter(QObject* object, QEvent* event)
{
    if (object == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(object, event);
}

void ScrollColumn::resizeEvent(QResizeEvent* event)
{
    QScrollArea::resizeEvent(event);
    if (event->size().width() != event->oldSize().width()) updateGeometry();
}

}  // namespace terratact
