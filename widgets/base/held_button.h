#pragma once

#include <QElapsedTimer>
#include <QPushButton>
#include <QTimer>
#include <functional>
#include <utility>

#include "widgets/base/palette.h"

namespace terratact {

/// A hold-to-run button (dead-man control). It is held with the left mouse button, or with Space when it has the focus.
/// A window-wide key uses hold() and letGo(). It releases when the mouse leaves it, it loses the focus, or it is hidden
/// or disabled. It also releases when its window is no longer active.
class HeldButton : public QPushButton {
    Q_OBJECT
public:
    explicit HeldButton(const QString& text, QWidget* parent = nullptr);
    bool isHeld() const { return held_; }
    /// A hold begins only while mayHold returns true.
    void setMayHold(std::function<bool()> mayHold) { mayHold_ = std::move(mayHold); }

public slots:
    void hold();
    void letGo();
    /// Releases after 40 ms unless hold() comes first. Some X servers repeat a held key as release and press, which
    /// passes for the operator's own release.
    void letGoSoon();
    /// Takes letGoSoon() back, for such a repetition. It begins no hold: one that has ended needs a new press.
    void holdOn() { release_.stop(); }

signals:
    void holdBegan();
    void holdEnded();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

    bool mayHold() const { return !mayHold_ || mayHold_(); }

private:
    bool held_ = false;
    std::function<bool()> mayHold_;
    QTimer release_;
};

/// A hold-to-confirm button. It confirms after the hold time; a closing ring and the fill show the progress. An early
/// release confirms nothing. The hold also ends as soon as holding is no longer allowed.
class HoldToConfirmButton final : public HeldButton {
    Q_OBJECT
public:
    /// fill: the theme's member with the button's colours.
    explicit HoldToConfirmButton(const QString& text, Fill Theme::*fill, QWidget* parent = nullptr);
    void setHoldTime(int milliseconds) { holdTime_ = milliseconds; }
    int holdTime() const { return holdTime_; }  ///< [ms]
    double share() const;                       ///< 0 … 1, elapsed share of the hold time

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;  ///< size with the text on two lines

signals:
    void confirmed();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void advance();
    QFont boldFont() const;

    Fill Theme::*fill_;
    int holdTime_ = 1500;  // [ms]
    // [ms], summed over frames of bounded length: a frozen window does not count as holding
    qint64 heldFor_ = 0;
    QElapsedTimer lastFrame_;
    QTimer frames_;
};

}  // namespace terratact
