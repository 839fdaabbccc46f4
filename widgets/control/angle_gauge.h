#pragma once

#include <QRectF>

#include "app/display/drive_view_state.h"

class QColor;
class QPainter;

namespace terratact {

/// Draws a thin scale of an angle, with zero in the middle and a bar from zero to the angle. A
/// short tick marks each amber limit, a long one each red limit. Without an angle, draws only the
/// axes.
void drawAngleGauge(QPainter& painter, const QRectF& area,
                    const std::optional<DriveViewState::Angle>& angle, const QColor& ink);

}  // namespace terratact
