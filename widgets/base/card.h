#pragma once

#include <QFrame>
#include <QMargins>

#include "app/display/tone.h"

class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace terratact {

/// A titled panel: the title at the left, a note at the right, the content below.
class Card : public QFrame {
    Q_OBJECT
public:
    explicit Card(const QString& title, QWidget* parent = nullptr);

    QVBoxLayout* body() const { return body_; }
    QHBoxLayout* titleRow() const { return titleRow_; }  ///< row for controls beside the title
    QLabel* note() const { return note_; }
    void setNote(const QString& text, Tone tone);
    void setTitle(const QString& title);
    void setTitleShown(bool shown);  ///< also shows or hides the note
    int frameHeight() const;         ///< [px] above and below the body, title included

protected:
    static constexpr QMargins kMargins{14, 8, 14, 10};  ///< [px] around the body
    static constexpr int kSpacing = 5;                  ///< [px] between the body's items

private:
    QLabel* heading_ = nullptr;
    QHBoxLayout* titleRow_ = nullptr;
    QVBoxLayout* body_ = nullptr;
    QLabel* note_ = nullptr;
};

}  // namespace terratact
