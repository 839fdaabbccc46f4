#pragma once

#include <QFont>
#include <QStringList>
#include <QWidget>
#include <utility>
#include <vector>

#include "app/display/drive_view_state.h"
#include "widgets/base/palette.h"
#include "widgets/control/contact_map.h"

namespace terratact {

/// How much a cell of the drive strip shows: limits in numbers, only their ticks, or short words in a smaller font.
enum class DriveDetail : std::uint8_t { Limits, Words, Short };

/// A value of the drive strip under its caption: a number, an angle with its gauge, or contacts with their map. A level
/// fills the cell. It paints itself, because labels with a style sheet make a change of the font slow. Screen
/// readers get the name and the description. Takes values, emits nothing.
class DriveCell final : public QWidget {
    Q_OBJECT
public:
    struct Content {
        QString caption{}, shortCaption{};
        QString value{};
        QString shortValue{};  ///< of the narrowest form; empty: `value`
        QString limits{};      ///< of an angle, in numbers
        QString level{};       ///< "amber", "red", "contact" or nothing
        std::optional<DriveViewState::Angle> angle{};
        std::optional<FlipperContacts> contacts{};
        bool operator==(const Content&) const = default;
    };
    enum class Kind : std::uint8_t { Number, Angle, Contact };
    /// Widest texts, for which the cell keeps room.
    struct Widest {
        QStringList captions, shortCaptions, values;
        QString limits;
        QStringList shortValues{};  ///< empty: `values`
    };
    DriveCell(Kind kind, Widest widest, QWidget* parent);

    void setContent(const Content& content);
    const Content& content() const { return content_; }
    void setDetail(DriveDetail detail);
    int widthFor(DriveDetail detail) const;  ///< [px]
    static int heightOfAll();                ///< [px] of every cell in the present font
    /// A text in one line. The font shrinks where a rare text, such as a rear contact, does not fit.
    struct Line {
        QRectF area;
        QFont font;
        QString text;
    };
    std::vector<Line> lines() const;  ///< what is painted
    bool fits() const;                ///< true if no line is painted in a smaller font
    QSize sizeHint() const override { return {widthFor(detail_), heightOfAll()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ContactMap map(DriveDetail detail) const;
    ContactMap map() const;
    QRectF inside() const;
    std::pair<QRectF, QRectF> areas() const;
    void drawPicture(QPainter& painter, const Fill& fill) const;

    Kind kind_;
    Widest widest_;
    Content content_;
    DriveDetail detail_ = DriveDetail::Words;
};

}  // namespace terratact
