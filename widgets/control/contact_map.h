#pragma once

#include <QRectF>
#include <QSize>
#include <optional>

#include "core/atem/contact_watch.h"
#include "widgets/base/palette.h"

class QPainter;

namespace terratact {

/// Force elements of the flippers, the left row above the right one, as seen from above with the front at the right. An
/// element is a box with its number: filled where it touches the ground, with a bar of its force where it does not, and
/// crossed out where it is not known. The rear elements are shown if they are known. A small map has no letters.
struct ContactMap {
    std::optional<FlipperContacts> contacts{};  ///< empty: nothing is known
    bool isSmall = false;

    QSize size() const;  ///< [px]
    /// Draws the map at the right of an area, centred in its height, in the colours of the area.
    void draw(QPainter& painter, const QRectF& area, const Fill& fill) const;
};

}  // namespace terratact
