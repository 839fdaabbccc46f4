#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/earlier_layer.h"
#include "widgets/terrain/picture_touch.h"
#include "widgets/terrain/remembered_layer.h"
#include "widgets/terrain/terrain_profile_view.h"

// The window over the terrain: zoom and pan by mouse, keys and fingers.

namespace terratact {
namespace {

constexpr double kStepOfZoom = 1.25;  // of the wheel and the keys
constexpr double kBeyond = 0.3;       // [m] beyond the strip's ends
constexpr double kClosest = 0.125;    // least zoom: the width of two bins

/// Returns the x of the ends of the strip and of earlier ground [m]. If the robot's picture is longer, returns its
/// ends.
std::array<double, 2> endsOf(const SeenStrip& strip, const EarlierLayer& earlier)
{
    std::array<double, 2> ends{ProfileAxes::kLeft, ProfileAxes::kRight};
    for (const auto& side : strip.side) {
        if (side.empty()) continue;
        ends[0] = std::min(ends[0], side.front().x - kBeyond);
        ends[1] = std::max(ends[1], side.back().x + kBeyond);
    }
    if (earlier.count() > 0) ends[0] = std::min(ends[0], earlier.begin() - kBeyond);
    return ends;
}

}  // namespace

void TerrainProfileView::setWindow(double zoom, double shift, double rise)
{
    const auto [begin, end] = endsOf(remembered_->strip(), *earlier_);
    const double most = std::max(1.0, (end - begin) / (ProfileAxes::kRight - ProfileAxes::kLeft));
    double within = std::clamp(zoom, kClosest, most);
    if (std::abs(within - 1.0) < 1e-6) within = 1.0;  // after as many steps closer as away
    // Both ends of the window stay within those of the strip.
    const double spare = (within - 1.0) * (ProfileAxes::kRight - ProfileAxes::kLeft) / 2.0;
    const double least = begin - ProfileAxes::kLeft + spare;
    const double farthest = std::max(least, end - ProfileAxes::kRight - spare);
    axes_.setWindow(within, std::clamp(shift, least, farthest), within < 1.0 ? rise : 0.0);
}

void TerrainProfileView::showWindow()
{
    inspect(std::nullopt);  // its bin has moved
    fitAxes();
    showMeasurement();
    replot();
}

void TerrainProfileView::zoom(double factor, double x)
{
    zoomAt(factor, {x, middleHeight()});
}

double TerrainProfileView::middleHeight() const
{
    const QwtScaleDiv& shown = axisScaleDiv(QwtPlot::yLeft);
    return (shown.lowerBound() + shown.upperBound()) / 2.0;
}

void TerrainProfileView::zoomAt(double factor, QPointF at)
{
    const double before = axes_.zoom();
    const double middle = (axes_.left() + axes_.right()) / 2.0;
    const double wanted = std::max(before * factor, kClosest);
    const double real = wanted / before;
    const double rise = axes_.rise() + (at.y() - middleHeight()) * (1.0 - real);
    setWindow(wanted, axes_.shift() + (at.x() - middle) * (1.0 - real), rise);
    showWindow();
}

void TerrainProfileView::pan(double metres)
{
    panBy({metres, 0.0});
}

void TerrainProfileView::panBy(QPointF metres)
{
    setWindow(axes_.zoom(), axes_.shift() + metres.x(), axes_.rise() + metres.y());
    showWindow();
}

void TerrainProfileView::resetZoom()
{
    axes_.setWindow(1.0, 0.0);
    showWindow();
}

void TerrainProfileView::press(QPointF pixel)
{
    grabbed_ = pointAt(pixel);
    isDrawn_ = false;
}

void TerrainProfileView::drag(QPointF pixel)
{
    if (!grabbed_) return;
    const QPointF at = pointAt(pixel);
    if (!measures_) return panBy(*grabbed_ - at);
    if (!isDrawn_) ends_[0] = endNear(*grabbed_);
    isDrawn_ = true;
    ends_[1] = endNear(at);
    showMeasurement();
    replot();
}

void TerrainProfileView::choose(QPointF pixel)
{
    if (isZoomed()) return resetZoom();
    const std::optional<int> bin = binOf(pointAt(pixel).x());
    if (bin && !measures_) emit binChosen({*bin, sideToProbe()});
}

/// Zooms, pans and measures by the mouse. Returns true if that is all that the event does.
bool TerrainProfileView::navigate(QEvent& event)
{
    const auto mouse = [&event]() -> const QMouseEvent& {
        return static_cast<const QMouseEvent&>(event);
    };
    switch (event.type()) {
    case QEvent::Wheel: {
        const auto& wheel = static_cast<QWheelEvent&>(event);
        constexpr double kNotch = 120.0;
        zoomAt(std::pow(kStepOfZoom, -wheel.angleDelta().y() / kNotch), pointAt(wheel.position()));
        event.accept();
        return true;
    }
    case QEvent::MouseButtonDblClick:
        if (mouse().button() == Qt::LeftButton) choose(mouse().position());
        return true;
    case QEvent::MouseButtonPress:
        if (mouse().button() == Qt::LeftButton) press(mouse().position());
        return false;
    case QEvent::MouseButtonRelease:
    case QEvent::Leave: grabbed_.reset(); return false;
    case QEvent::MouseMove:
        drag(mouse().position());
        if (!grabbed_ && !measures_) inspect(binOf(pointAt(mouse().position()).x()));
        return grabbed_.has_value();
    default: return false;
    }
}

bool TerrainProfileView::navigateByKey(const QKeyEvent& event)
{
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    const QPointF middle((axes_.left() + axes_.right()) / 2.0, middleHeight());
    const double quarter = (axes_.right() - axes_.left()) / 4.0;
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomAt(1.0 / kStepOfZoom, middle); return true;
    case Qt::Key_Minus: zoomAt(kStepOfZoom, middle); return true;
    case Qt::Key_0: resetZoom(); return true;
    case Qt::Key_Left:
        if (shift) pan(-quarter);
        return shift;
    case Qt::Key_Right:
        if (shift) pan(quarter);
        return shift;
    case Qt::Key_Up:
        if (shift) panBy({0.0, quarter});
        return shift;
    case Qt::Key_Down:
        if (shift) panBy({0.0, -quarter});
        return shift;
    default: return false;
    }
}

void TerrainProfileView::addTouch()
{
    PictureGestures gestures;
    gestures.pressed = [this](QPointF at) { press(at); };
    gestures.moved = [this](QPointF at) { drag(at); };
    gestures.released = [this](QPointF) { grabbed_.reset(); };
    gestures.hovered = [this](QPointF at) { inspect(binOf(pointAt(at).x())); };
    gestures.tapped = [this](QPointF at) {
        if (!measures_) inspect(binOf(pointAt(at).x()));
    };
    gestures.tappedTwice = [this](QPointF at) { choose(at); };
    gestures.pinched = [this](double factor, QPointF from, QPointF to) {
        const QPointF held = pointAt(from);
        if (factor > 0.0 && factor != 1.0) zoomAt(1.0 / factor, held);
        panBy(held - pointAt(to));
    };
    new PictureTouch(*canvas(), std::move(gestures));
}

}  // namespace terratact
