#pragma once

#include <QScrollArea>

class QLabel;

namespace terratact {

/// The sheet of the keys, a small window of its own: as large as it needs to be, and where there is less room it
/// scrolls.  Esc, F1 and ? close it.
class KeySheet final : public QScrollArea {
    Q_OBJECT
public:
    explicit KeySheet(QWidget* parent);

    /// html: what it says.  room: [px] that it may take at most.
    void setKeys(const QString& html, QSize room);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QLabel* text_ = nullptr;
};

}  // namespace terratact
