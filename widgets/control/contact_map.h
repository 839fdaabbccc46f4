#pragma once

#include <QRectF>
#include <QSize>
#include <optional>

#include "core/atem/contact_watch.h"
#include "widgets/base/palette.h"

class QPainter;

namespace terratact {

/// Force elements of the flippers from above, front at the right. The left row stands above the
/// right one. An element is a box with its number. It is filled where it touches the ground, else it
/// has a bar of its force. An unknown element is crossed out. The rear elements are shown if they are
/// known. A small map has no letters L and R.
struct ContactMap {
    std::optional<FlipperContacts> contacts{};  ///< empty: nothing is known
    bool isSmall = false;

    QSize size() const;  ///< [px]
    /// Draws the map at the right of an area, centred in its height, in the colours of the area.
    void draw(QPainter& painter, const QRectF& area, const Fill& fill) const;
};

}  // namespace terratact
