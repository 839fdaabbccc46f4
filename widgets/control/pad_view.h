#pragma once

#include <QString>
#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

namespace terratact {

/// One control of a gamepad, or one action: a lamp or a bar, and a text.
struct PadLine {
    /// Waits: it is on, but does not count before it was released.
    enum class State : std::uint8_t { Off, On, Waits };
    struct Bar {
        double value = 0.0;      ///< −1 … 1 of a stick, 0 … 1 of a trigger
        bool fromMiddle = true;  ///< of a stick
        double deadZone = 0.0;   ///< share of the way
        bool operator==(const Bar&) const = default;
    };
    QString text;
    State state = State::Off;
    std::optional<Bar> bar{};  ///< drawn instead of the lamp
    bool operator==(const PadLine&) const = default;
};

/// Lines of a gamepad in columns, from top to bottom. Takes values, emits nothing. It draws all lines itself, because
/// fifty labels would delay a change of theme or font.
class PadView final : public QWidget {
    Q_OBJECT
public:
    explicit PadView(int columns, QWidget* parent = nullptr);

    void setLines(std::vector<PadLine> lines);
    const std::vector<PadLine>& lines() const { return lines_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    int rows() const;
    int lineHeight() const;  ///< [px]
    int textWidth() const;   ///< [px] of the longest line
    QFont boldFont() const;
    void draw(class QPainter& painter, const PadLine& line, const QRectF& area) const;

    int columns_;
    std::vector<PadLine> lines_;
};

}  // namespace terratact
