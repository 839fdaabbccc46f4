#pragma once

#include <QScrollArea>

class QVBoxLayout;

namespace terratact {

/// Lines of text below each other at their full height. If the height is too small they scroll, and Tab focuses them.
class ScrollColumn final : public QScrollArea {
    Q_OBJECT
public:
    /// minimum: at least leastLines lines stay visible.
    explicit ScrollColumn(int leastLines, QWidget* parent = nullptr);

    QVBoxLayout* column() const { return column_; }
    void setLeastLines(int lines);
    bool isScrolled() const;  ///< true if some lines are out of view

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
