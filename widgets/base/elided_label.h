#pragma once

#include "widgets/base/plain_label.h"

namespace terratact {

/// A line whose text changes: it keeps the room of the texts that are usual, and ends in "…" where a text has less
/// than it needs.  The tip then says all of it; text() always does.
class ElidedLabel final : public PlainLabel {
    Q_OBJECT
public:
    using PlainLabel::PlainLabel;

    /// Room for each of these is wanted, whatever is shown.
    void setUsual(const QStringList& texts);
    /// So many letters of a text are seen in any case.
    void setLeastLetters(int letters);
    int usualWidth() const;  ///< [px] that all of them need; of the text where there are none
    bool isElided() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    int widthOf(const QString& text) const;

    QStringList usual_;
    int leastLetters_ = 9;  ///< with fewer, nobody knows what it is about
};

}  // namespace terratact
