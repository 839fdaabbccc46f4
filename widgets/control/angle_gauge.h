#pragma once

#include <QColor>
#include <QWidget>
#include <optional>

#include "app/display/drive_view_state.h"

namespace terratact {

/// A thin scale of an angle: zero in the middle, a short tick at each amber limit, a long one at each red limit, and a
/// bar from zero to the angle. Takes values, emits nothing.
class AngleGauge final : public QWidget {
    Q_OBJECT
public:
    explicit AngleGauge(QWidget* parent = nullptr);

    void setAngle(const std::optional<DriveViewState::Angle>& angle);
    void setInk(const QColor& ink);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<DriveViewState::Angle> angle_;
    QColor ink_;
};

}  // namespace terratact
