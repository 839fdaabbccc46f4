#include "app/text_sheet.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTextDocumentFragment>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "widgets/palette.h"
#include "widgets/tips.h"

namespace terratact {

QString withoutResources(const QString& html)
{
    static const QRegularExpression kOther(QStringLiteral(
        "<(?!/?(?:h3|p|b|table|tr|td)(?: (?:cellpadding|valign|width)=[a-z0-9]+)*>)"));
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
    text_ = new QLabel(area_);
    text_->setTextFormat(Qt::RichText);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    text_->setMargin(18);
    area_->setWidget(text_);
    copy_ = new QPushButton(tr("Copy as text"), this);
    setTip(*copy_, tr("All of it, for a report"));
    connect(copy_, &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(plainText()); });
    close_ = new QPushButton(tr("Close (Esc)"), this);
    connect(close_, &QPushButton::clicked, this, &QWidget::close);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(18, 8, 18, 12);
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
    text_->setWordWrap(false);
    text_->setText(withoutResources(html));
    const int bar = area_->verticalScrollBar()->sizeHint().width();
    const int width = std::min(widest, room.width() - bar);
    QSize needed = text_->sizeHint();
    if (needed.width() > width) {
        text_->setWordWrap(true);
        needed = {width, text_->heightForWidth(width)};
    }
    const QSize row = layout()->itemAt(1)->sizeHint();
    needed = {std::max(needed.width(), row.width()), needed.height() + row.height()};
    if (needed.height() > room.height()) needed.rwidth() += bar;
    resize(needed.boundedTo(room));
}

QString TextSheet::plainText() const
{
    return QTextDocumentFragment::fromHtml(text_->text()).toPlainText();
}

void TextSheet::keyPressEvent(QKeyEvent* event)
{
    if (closedBy_.contains(event->key())) return void(close());
    QWidget::keyPressEvent(event);
}

}  // namespace terratact
