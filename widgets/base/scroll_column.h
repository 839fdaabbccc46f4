#pragma once

#include <QScrollArea>

class QVBoxLayout;

namespace terratact {

/// Lines one below the other, as high as they need where there is the room; else they scroll, and Tab reaches them.
class ScrollColumn final : public QScrollArea {
    Q_OBJECT
public:
    /// leastLines: so many of them are seen in any case.
    explicit ScrollColumn(int leastLines, QWidget* parent = nullptr);

    QVBoxLayout* column() const { return column_; }
    void setLeastLines(int lines);
    bool isScrolled() const;  ///< not all of it is seen

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void settle();

    int leastLines_;
    QVBoxLayout* column_ = nullptr;
};

}  // namespace terratact
