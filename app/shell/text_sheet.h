#pragma once

#include <QList>
#include <QWidget>

class QPushButton;
class QScrollArea;

namespace terratact {

class SheetText;

/// Returns HTML that cannot load files. Only headings, paragraphs, tables and bold text without foreign attributes keep
/// their tags; all other tags are shown as text. Qt would open the file an image names, even a device or a pipe.
QString withoutResources(const QString& html);

/// A small window with a text. It is as large as the text needs, or scrolls. The text can be copied; Esc closes the
/// window.
class TextSheet final : public QWidget {
    Q_OBJECT
public:
    /// closedBy: further keys that close it.
    TextSheet(const QString& title, QList<int> closedBy, QWidget* parent);

    /// html: text in lines of at most `widest` [px]. room: maximum size of the window [px].
    void setText(const QString& html, QSize room, int widest = QWIDGETSIZE_MAX);
    QString plainText() const;  ///< text as copied

    QScrollArea* area() const { return area_; }
    QPushButton* copyButton() const { return copy_; }

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QList<int> closedBy_;
    QScrollArea* area_ = nullptr;
    SheetText* text_ = nullptr;
    QPushButton* copy_ = nullptr;
    QPushButton* close_ = nullptr;
};

}  // namespace terratact
