#pragma once

#include <QFrame>
#include <array>

#include "app/display/drive_view_state.h"
#include "widgets/control/drive_cell.h"

namespace terratact {

/// What a driver needs at a glance, in one row. It has pitch and roll with their limits, contact by
/// flipper and segment, and speed. It also has the distance since the last estimate, and how far
/// the ground is felt. A level or a contact fills its cell and is named with a mark and a word. A
/// narrow strip leaves out the limits in numbers, then the words of the captions; marks, fills and
/// gauges stay. Takes values, emits nothing.
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

    DriveDetail detail() const { return detail_; }
    int widthFor(DriveDetail detail) const;  ///< [px]
    QSize minimumSizeHint() const override;
    QSize sizeHint() const override { return minimumSizeHint(); }

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void place();
    void showAngle(Cell cell, const std::optional<DriveViewState::Angle>& angle);
    void showContact(const std::optional<FlipperContacts>& contact);
    void showDistances(const DriveViewState& viewState);
    void show(Cell cell, const DriveCell::Content& content, const QString& description);

    std::array<DriveCell*, kCells> cells_{};  // Qt's parents own the widgets
    DriveDetail detail_ = DriveDetail::Words;
    DriveViewState viewState_;
};

}  // namespace terratact
