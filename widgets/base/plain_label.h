#pragma once

#include <QLabel>

class QFormLayout;

namespace terratact {

/// A label that shows plain text only. QLabel would interpret text like HTML and load the files it names. Text from an
/// untrusted file could then block the window or imitate a verdict. Every label of the console is a PlainLabel, except
/// the key sheet, whose HTML is the program's own.
class PlainLabel : public QLabel {
    Q_OBJECT
public:
    explicit PlainLabel(QWidget* parent = nullptr);
    explicit PlainLabel(const QString& text, QWidget* parent = nullptr);

    void setTextFormat(Qt::TextFormat) = delete;  ///< always Qt::PlainText
};

/// Adds a form row: the name as a plain label whose mnemonic focuses the field.
void addField(QFormLayout& form, const QString& name, QWidget* field);

}  // namespace terratact
