#pragma once

#include <QElapsedTimer>
#include <QPushButton>
#include <QTimer>
#include <functional>
#include <utility>

#include "widgets/base/palette.h"

namespace terratact {

/// A button that acts while it is held: by the left mouse button, by Space when it has the focus, or by
/// hold() and letGo() from a window-wide key.  It lets go by itself when the mouse leaves it, it loses
/// the focus, is hidden or disabled, or its window is no longer the active one.
class HeldButton : public QPushButton {
    Q_OBJECT
public:
    explicit HeldButton(const QString& text, QWidget* parent = nullptr);
    bool isHeld() const { return held_; }
    /// A hold begins only where this says so.
    void setMayHold(std::function<bool()> mayHold) { mayHold_ = std::move(mayHold); }

public slots:
    void hold();
    void letGo();
    /// For a key's release.  Some X servers repeat a held key as release and press, indistinguishable
    /// from an operator's; so a release counts 40 ms later, unless hold() comes first.
    void letGoSoon();

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

/// A button that must be held for a while before it means yes; a ring that closes around it and its fill show how far.
/// Letting go early means nothing.  It lets go, too, as soon as it may not be held any more.
class HoldToConfirmButton final : public HeldButton {
    Q_OBJECT
public:
    /// fill: which of the theme's it has.
    explicit HoldToConfirmButton(const QString& text, Fill Theme::*fill, QWidget* parent = nullptr);
    void setHoldTime(int milliseconds) { holdTime_ = milliseconds; }
    int holdTime() const { return holdTime_; }  ///< [ms]
    double share() const;                       ///< 0 … 1 of the time held

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;  ///< with the text on two lines

signals:
    void confirmed();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void advance();
    QFont boldFont() const;

    Fill Theme::*fill_;
    int holdTime_ = 1500;  // [ms]
    qint64 heldFor_ = 0;   // [ms] counted frame by frame: a frozen window holds nothing
    QElapsedTimer lastFrame_;
    QTimer frames_;
};

}  // namespace terratact
