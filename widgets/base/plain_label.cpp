#include "widgets/base/plain_label.h"

#include <QFormLayout>

namespace terratact {

PlainLabel::PlainLabel(QWidget* parent) : QLabel(parent)
{
    QLabel::setTextFormat(Qt::PlainText);
}

PlainLabel::PlainLabel(const QString& text, QWidget* parent) : PlainLabel(parent)
{
    setText(text);
}

void addField(QFormLayout& form, const QString& name, QWidget* field)
{
    auto* label = new PlainLabel(name);
    label->setBuddy(field);
    form.addRow(label, field);
}

}  // namespace terratact
