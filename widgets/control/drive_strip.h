#pragma once

#include <QFrame>
#include <array>

#include "app/display/drive_view_state.h"

class QGridLayout;
class QLabel;

namespace terratact {

class AngleGauge;
class ContactMap;

/// What a driver needs at a glance: pitch and roll with their limits, contact by flipper and segment, speed, distance
/// since the last estimate, and how far the ground is felt. A level or a contact fills its cell and is named with a
/// mark and a word. A narrow strip leaves out the limits in numbers; its gauges still show them. Takes values, emits
/// nothing.
class DriveStrip final : public QFrame {
    Q_OBJECT
public:
    explicit DriveStrip(QWidget* parent = nullptr);

    void setViewState(const DriveViewState& viewState);
    const DriveViewState& viewState() const { return viewState_; }

    enum Cell { Pitch, Roll, Contact, Speed, Way, FeltTo, kCells };
    QString text(Cell cell) const;     ///< shown value
    QString caption(Cell cell) const;  ///< shown caption, with mark and word of a level
    QString level(Cell cell) const;    ///< "amber", "red", "contact" or nothing

    /// Arranges the cells in one row or in two.
    void setRows(int rows);
    int rows() const { return rows_; }
    int widthOfOneRow() const;  ///< [px] without the limits in numbers
    QSize minimumSizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Parts {
        QFrame* frame = nullptr;
        QLabel *caption = nullptr, *value = nullptr;
        QLabel* limits = nullptr;  ///< of an angle
        AngleGauge* gauge = nullptr;
    };
    Parts newCell(Cell cell);
    void place();
    void resizeToFont();
    void showLimits();
    void showAngle(Cell cell, const std::optional<DriveViewState::Angle>& angle);
    void showContact(const std::optional<FlipperContacts>& contact);
    void showDistances(const DriveViewState& viewState);
    int cellWidth(Cell cell) const;  ///< [px] without the limits in numbers
    int limitsWidth() const;         ///< [px] more that the limits of both angles need

    // Qt's parents own the widgets.
    std::array<Parts, kCells> cells_{};
    ContactMap* map_ = nullptr;
    std::array<int, kCells> words_{};  ///< [px] widest words of each cell
    int limits_ = 0;                   ///< [px] limitsWidth()
    QGridLayout* grid_ = nullptr;
    int rows_ = 1;
    DriveViewState viewState_;
};

}  // namespace terratact
