#include "widgets/base/tips.h"

#include <qwt_text.h>

#include <QAction>
#include <QPoint>
#include <QTableWidgetItem>
#include <QTextDocumentFragment>
#include <QToolTip>
#include <QWidget>

namespace terratact {
namespace {

QString shownAsItIs(const QString& text)
{
    return Qt::mightBeRichText(text) ? plainTip(text) : text;
}

}  // namespace

QString plainTip(const QString& text)
{
    return text.isEmpty()
             ? QString()
             : QStringLiteral("<p style='white-space:pre-wrap'>%1</p>").arg(text.toHtmlEscaped());
}

void setTip(QWidget& widget, const QString& text)
{
    widget.setToolTip(shownAsItIs(text));
}

void setTip(QAction& action, const QString& text)
{
    action.setToolTip(shownAsItIs(text));
}

void setTip(QTableWidgetItem& cell, const QString& text)
{
    cell.setToolTip(shownAsItIs(text));
}

void showTip(const QPoint& global, const QString& text, QWidget* widget)
{
    QToolTip::showText(global, shownAsItIs(text), widget);
}

QString tipOf(const QWidget& widget)
{
    const QString tip = widget.toolTip();
    return Qt::mightBeRichText(tip) ? QTextDocumentFragment::fromHtml(tip).toPlainText() : tip;
}

void keepPlotsPlain()
{
    QwtText::setTextEngine(QwtText::RichText, nullptr);
}

}  // namespace terratact
