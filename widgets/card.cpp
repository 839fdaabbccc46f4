#include "widgets/card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "widgets/look.h"

namespace terratact {

Card::Card(const QString& title, QWidget* parent) : QFrame(parent)
{
    setProperty("card", true);
    setAccessibleName(title);
    body_ = new QVBoxLayout(this);
    body_->setContentsMargins(14, 8, 14, 10);
    body_->setSpacing(5);
    titleRow_ = new QHBoxLayout;
    titleRow_->setSpacing(12);
    auto* heading = new QLabel(title, this);
    heading->setProperty("heading", true);
    note_ = new QLabel(this);
    note_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setTone(*note_, Tone::Muted);
    titleRow_->addWidget(heading);
    titleRow_->addWidget(note_, 1);
    body_->addLayout(titleRow_);
}

}  // namespace terratact
