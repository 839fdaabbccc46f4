#pragma once

#include "widgets/base/plain_label.h"

namespace terratact {

/// A one-line label for a changing text. It keeps the width of its usual texts and elides a longer text with "…". The
/// tip then shows the whole text; text() always returns it.
class ElidedLabel final : public PlainLabel {
    Q_OBJECT
public:
    using PlainLabel::PlainLabel;

    /// The size hint leaves room for each of these texts, whichever is shown.
    void setUsual(const QStringList& texts);
    /// The minimum width shows at least this many characters.
    void setMinCharacters(int letters);
    /// [px] widest usual text; width of the current text if no usual texts are set.
    int usualWidth() const;
    bool isElided() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    int widthOf(const QString& text) const;

    QStringList usual_;
    int minCharacters_ = 9;  ///< fewer characters do not identify the text
};

}  // namespace terratact
