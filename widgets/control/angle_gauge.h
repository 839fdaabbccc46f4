#pragma once

#include <QRectF>

#include "app/display/drive_view_state.h"

class QColor;
class QPainter;

namespace terratact {

/// Draws a thin scale of an angle: zero in the middle, a short tick at each amber limit, a long one at each red limit,
/// and a bar from zero to the angle. Without an angle, draws only the axes.
void drawAngleGauge(QPainter& painter, const QRectF& area,
                    const std::optional<DriveViewState::Angle>& angle, const QColor& ink);

}  // namespace terratact
