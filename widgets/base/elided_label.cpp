#include "widgets/base/elided_label.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStyle>
#include <algorithm>

#include "widgets/base/tips.h"

namespace terratact {

void ElidedLabel::setUsual(const QStringList& texts)
{
    if (texts == usual_) return;
    usual_ = texts;
    updateGeometry();
}

void ElidedLabel::setMinCharacters(int letters)
{
    minCharacters_ = letters;
    updateGeometry();
}

int ElidedLabel::widthOf(const QString& text) const
{
    const int frame = QLabel::sizeHint().width() - fontMetrics().size(0, this->text()).width();
    return fontMetrics().size(0, text).width() + frame;
}

int ElidedLabel::usualWidth() const
{
    int width = usual_.isEmpty() ? widthOf(text()) : 0;
    for (const QString& text : usual_) width = std::max(width, widthOf(text));
    return width;
}

bool ElidedLabel::isElided() const
{
    return width() < widthOf(text());
}

QSize ElidedLabel::sizeHint() const
{
    return {std::max(usualWidth(), widthOf(text())), QLabel::sizeHint().height()};
}

QSize ElidedLabel::minimumSizeHint() const
{
    const int least = widthOf(QString(minCharacters_, QLatin1Char('n')));
    return {std::min(sizeHint().width(), least), QLabel::sizeHint().height()};
}

bool ElidedLabel::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip || !isElided()) return QLabel::event(event);
    const QString tip = toolTip().isEmpty() ? text() : text() + QLatin1Char('\n') + tipOf(*this);
    showTip(static_cast<QHelpEvent*>(event)->globalPos(), tip, this);
    return true;
}

void ElidedLabel::paintEvent(QPaintEvent* event)
{
    if (!isElided()) return QLabel::paintEvent(event);
    QPainter painter(this);
    drawFrame(&painter);
    const QRect room = contentsRect();
    style()->drawItemText(&painter, room, static_cast<int>(alignment()), palette(), isEnabled(),
                          fontMetrics().elidedText(text(), Qt::ElideRight, room.width()),
                          foregroundRole());
}

}  // namespace terratact
