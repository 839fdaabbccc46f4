#pragma once

#include <QLabel>

class QFormLayout;

namespace terratact {

/// A label that shows its text as it is.  A QLabel takes what looks like HTML for HTML, and loads the files that this
/// names: a text from somebody's file could then hang the window, or paint a verdict.  Every label of the console is one
/// of these, but for the sheet of the keys, whose HTML is the program's own.
class PlainLabel : public QLabel {
    Q_OBJECT
public:
    explicit PlainLabel(QWidget* parent = nullptr);
    explicit PlainLabel(const QString& text, QWidget* parent = nullptr);

    void setTextFormat(Qt::TextFormat) = delete;  ///< it is Qt::PlainText
};

/// A row of a form: the name as a plain label, whose mnemonic leads to the field.
void addField(QFormLayout& form, const QString& name, QWidget* field);

}  // namespace terratact
