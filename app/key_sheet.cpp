#include "app/key_sheet.h"

#include <QKeyEvent>
#include <QLabel>
#include <QScrollBar>

namespace terratact {

KeySheet::KeySheet(QWidget* parent) : QScrollArea(parent)
{
    setWindowFlags(Qt::Tool);
    setWindowTitle(tr("Keys"));
    setAccessibleName(tr("Keys"));
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    text_ = new QLabel(this);
    text_->setTextFormat(Qt::RichText);
    text_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    text_->setMargin(18);
    setWidget(text_);
}

void KeySheet::setKeys(const QString& html, QSize room)
{
    text_->setWordWrap(false);
    text_->setText(html);
    QSize needed = text_->sizeHint();
    const int bar = verticalScrollBar()->sizeHint().width();
    if (needed.width() > room.width()) {
        text_->setWordWrap(true);
        needed = {room.width() - bar, text_->heightForWidth(room.width() - bar)};
    }
    if (needed.height() > room.height()) needed.rwidth() += bar;
    resize(needed.boundedTo(room));
}

void KeySheet::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Escape:
    case Qt::Key_F1:
    case Qt::Key_Question: close(); return;
    default: QScrollArea::keyPressEvent(event);
    }
}

}  // namespace terratact
