#pragma once

#include <QList>
#include <QWidget>

class QPushButton;
class QScrollArea;

namespace terratact {

class SheetText;

/// HTML of which no tag can name a file to load: any but those of headings, paragraphs, tables and bold letters, or with
/// another attribute than theirs, is shown as it is written.  Qt opens what an image names, also a device or a pipe.
QString withoutResources(const QString& html);

/// A text in a small window of its own: as large as it needs to be, and where there is less room it scrolls.  It can be
/// copied; Esc closes it.
class TextSheet final : public QWidget {
    Q_OBJECT
public:
    /// closedBy: other keys that close it.
    TextSheet(const QString& title, QList<int> closedBy, QWidget* parent);

    /// html: what it says, in lines no longer than `widest` [px].  room: [px] that it may take at most.
    void setText(const QString& html, QSize room, int widest = QWIDGETSIZE_MAX);
    QString plainText() const;  ///< as it is copied

    QScrollArea* area() const { return area_; }
    QPushButton* copyButton() const { return copy_; }
    QPushButton* closeButton() const { return close_; }

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
