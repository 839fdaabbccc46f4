#pragma once

#include <QRectF>

class QPainter;

namespace terratact {

struct TwoTrackEstimate;

/// Draws a small estimate for lists: the band q10 … q90 and the line of each side over the bins. The left line is solid
/// and the right one dashed. Squares mark bins that contacts or the arm measured. All thumbnails have the same scale.
/// They show kThumbnailSpan of height about the ground under the robot (bins up to +0.2 m). The rest is cut off.
void drawTerrainThumbnail(QPainter& painter, const QRectF& area, const TwoTrackEstimate& estimate);
inline constexpr double kThumbnailSpan = 0.9;  ///< [m]

}  // namespace terratact
