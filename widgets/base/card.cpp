#include "widgets/base/card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"

namespace terratact {

Card::Card(const QString& title, QWidget* parent) : QFrame(parent)
{
    setProperty("card", true);
    setAccessibleName(title);
    body_ = new QVBoxLayout(this);
    body_->setContentsMargins(kMargins);
    body_->setSpacing(kSpacing);
    titleRow_ = new QHBoxLayout;
    titleRow_->setSpacing(12);
    heading_ = new PlainLabel(title, this);
    heading_->setProperty("heading", true);
    note_ = new PlainLabel(this);
    note_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setTone(*note_, Tone::Muted);
    titleRow_->addWidget(heading_);
    titleRow_->addWidget(note_, 1);
    body_->addLayout(titleRow_);
}

void Card::setNote(const QString& text, Tone tone)
{
    note_->setText(text);
    setTone(*note_, tone);
}

void Card::setTitle(const QString& title)
{
    heading_->setText(title);
}

void Card::setTitleShown(bool shown)
{
    heading_->setVisible(shown);
    note_->setVisible(shown);
}

int Card::frameHeight() const
{
    const QMargins margins = body_->contentsMargins();
    const int title = titleRow_->minimumSize().height();
    return margins.top() + margins.bottom() + title + (title > 0 ? body_->spacing() : 0);
}

}  // namespace terratact
