#include "app/shell/text_sheet.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTextDocument>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/base/palette.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr int kMargin = 18;  // [px] around the text

}  // namespace

/// Lays the text out twice. QLabel does so for every width it is asked about. For the key sheet that takes 50 ms
/// instead of 10 ms.
class SheetText final : public QWidget {
public:
    using QWidget::QWidget;

    void setHtml(const QString& html, int widest)
    {
        widest_ = widest;
        document_.setDocumentMargin(kMargin);
        document_.setHtml(html);
        layOut();
        setAccessibleDescription(plainText());
    }
    QString plainText() const { return document_.toPlainText(); }
    QSize sizeHint() const override { return document_.size().toSize(); }

protected:
    void changeEvent(QEvent* event) override
    {
        QWidget::changeEvent(event);
        if (event->type() == QEvent::FontChange && isVisible())
            layOut();  // setHtml() precedes show()
    }
    void paintEvent(QPaintEvent* event) override
    {
        QPainter painter(this);
        painter.setClipRect(event->rect());
        QAbstractTextDocumentLayout::PaintContext context;
        context.palette = palette();
        context.palette.setColor(QPalette::Text, palette().color(QPalette::WindowText));
        context.clip = event->rect();
        document_.documentLayout()->draw(&painter, context);
    }

private:
    void layOut()
    {
        document_.setDefaultFont(font());
        document_.setTextWidth(-1.0);  // resets the width, so that the natural size is measured
        document_.setTextWidth(std::min<qreal>(std::ceil(document_.idealWidth()), widest_));
        setMinimumSize(sizeHint());
        updateGeometry();
    }

    QTextDocument document_;
    int widest_ = QWIDGETSIZE_MAX;  ///< [px]
};

QString withoutResources(const QString& html)
{
    static const QRegularExpression kOther(QStringLiteral(
        "<(?!/?(?:h3|p|b|table|tr|td)(?: (?:cellpadding|valign|width)=[a-z0-9]+%?)*>)"));
    return QString(html).replace(kOther, QStringLiteral("&lt;"));
}

TextSheet::TextSheet(const QString& title, QList<int> closedBy, QWidget* parent)
    : QWidget(parent, Qt::Tool), closedBy_(std::move(closedBy) << Qt::Key_Escape)
{
    setWindowTitle(title);
    setAccessibleName(title);
    area_ = new QScrollArea(this);
    area_->setFrameShape(QFrame::NoFrame);
    area_->setWidgetResizable(true);
    area_->setAccessibleName(title);
    text_ = new SheetText(area_);
    area_->setWidget(text_);
    copy_ = new QPushButton(tr("Copy as text"), this);
    setTip(*copy_, tr("Copies everything, for a report"));
    connect(copy_, &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(plainText()); });
    close_ = new QPushButton(tr("Close (Esc)"), this);
    connect(close_, &QPushButton::clicked, this, &QWidget::close);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(18, 8, 18, 12);
    buttons->setSpacing(8);
    buttons->addStretch(1);
    for (QPushButton* button : {copy_, close_}) {
        button->setFocusPolicy(Qt::TabFocus);
        buttons->addWidget(button);
    }
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(area_, 1);
    column->addLayout(buttons);
    area_->setFocus();
}

void TextSheet::setText(const QString& html, QSize room, int widest)
{
    for (QPushButton* button : {copy_, close_}) button->setMinimumHeight(scaled(kTarget));
    const int bar = area_->verticalScrollBar()->sizeHint().width();
    text_->ensurePolished();      // ensures the style sheet's font
    constexpr int kRounding = 2;  // [px] a table may be wider by its columns' rounding
    text_->setHtml(withoutResources(html), std::min(widest, room.width() - bar - kRounding));
    QSize needed = text_->sizeHint();
    const QSize row = layout()->itemAt(1)->sizeHint();
    needed = {std::max(needed.width(), row.width()), needed.height() + row.height()};
    if (needed.height() > room.height()) needed.rwidth() += bar;
    resize(needed.boundedTo(room));
}

QString TextSheet::plainText() const
{
    return text_->plainText();
}

void TextSheet::keyPressEvent(QKeyEvent* event)
{
    if (closedBy_.contains(event->key())) return void(close());
    QWidget::keyPressEvent(event);
}

}  // namespace terratact
