#include <qwt_plot_textlabel.h>
#include <qwt_text.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/display/format.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_plot.h"
#include "widgets/terrain/remembered_layer.h"
#include "widgets/terrain/terrain_items.h"
#include "widgets/terrain/terrain_profile_view.h"

// Remembered ground, and the window over it.

namespace terratact {
namespace {

constexpr double kStepOfZoom = 1.25;  // of the wheel and the keys
constexpr double kBeyond = 0.3;       // [m] beyond the strip's ends

/// Numbers about remembered ground.
struct RememberedNumbers {
    double sd = 0.0;   ///< [m] mean
    double way = 0.0;  ///< [m] rolled since the newest scene
};

/// Returns the numbers of the bins beside the robot; of all bins, if none is there.
RememberedNumbers numbersOf(const RememberedLayer& layer)
{
    double sum = 0.0, nearSum = 0.0, way = std::numeric_limits<double>::infinity();
    int bins = 0, nearBins = 0;
    for (const auto& side : layer.drawn())
        for (const SeenBin& bin : side) {
            sum += bin.band.sd;
            ++bins;
            way = std::min(way, bin.way);
            if (bin.x < ProfileAxes::kLeft || bin.x > ProfileAxes::kRight) continue;
            nearSum += bin.band.sd;
            ++nearBins;
        }
    if (bins == 0) return {};
    return {nearBins > 0 ? nearSum / nearBins : sum / bins, way};
}

/// Returns the x of the strip's ends [m]; those of the robot's picture, if it is shorter.
std::array<double, 2> endsOf(const SeenStrip& strip)
{
    std::array<double, 2> ends{ProfileAxes::kLeft, ProfileAxes::kRight};
    for (const auto& side : strip.side) {
        if (side.empty()) continue;
        ends[0] = std::min(ends[0], side.front().x - kBeyond);
        ends[1] = std::max(ends[1], side.back().x + kBeyond);
    }
    return ends;
}

}  // namespace

void TerrainProfileView::setRemembered(const SeenStrip& strip, const QString& why)
{
    if (strip == remembered_->strip() && why == whyNothingRemembered_) return;
    whyNothingRemembered_ = why;
    remembered_->setStrip(strip, estimate_.has_value());
    if (isZoomed()) setWindow(axes_.zoom(), axes_.shift());
    showRemembered();
    describe();
    fitAxes();
    replot();
}

void TerrainProfileView::showRemembered()
{
    if (remembered_->isBesideEstimate() != estimate_.has_value())
        remembered_->setStrip(SeenStrip(remembered_->strip()), estimate_.has_value());
    const bool isShown = remembered_->isShown();
    const RememberedNumbers numbers = numbersOf(*remembered_);
    const QString sd = format::number(100.0 * numbers.sd, 0);
    if (const QString title = tr("remembered ± %1 cm").arg(sd);
        isShown && title != remembered_->title().text())
        remembered_->setTitle(title);
    if (isShown != remembered_->testItemAttribute(QwtPlotItem::Legend)) {
        remembered_->setItemAttribute(QwtPlotItem::Legend, isShown);
        sizeLegend();
        QTimer::singleShot(0, this,
                           [this] { updateLayout(); });  // after the legend has laid out its lines
    }
    QString note = estimate_ || isShown ? QString() : whyNothingRemembered_;
    if (isShown && !estimate_)
        note = tr("remembered ground · %1 m driven since · heights ± %2 cm")
                   .arg(format::number(numbers.way, 2), sd);
    setLabel(*rememberedNote_,
             inked(note, isShown ? theme().sampled : theme().muted, sized(font(), 15, true)));
    arrangeNotes();
}

void TerrainProfileView::setWindow(double zoom, double shift)
{
    const auto [begin, end] = endsOf(remembered_->strip());
    const double most = std::max(1.0, (end - begin) / (ProfileAxes::kRight - ProfileAxes::kLeft));
    const double within = std::clamp(zoom, 1.0, most);
    // Both ends of the window stay within those of the strip.
    const double spare = (within - 1.0) * (ProfileAxes::kRight - ProfileAxes::kLeft) / 2.0;
    const double least = begin - ProfileAxes::kLeft + spare;
    const double farthest = std::max(least, end - ProfileAxes::kRight - spare);
    axes_.setWindow(within, std::clamp(shift, least, farthest));
}

void TerrainProfileView::showWindow()
{
    inspect(std::nullopt);  // its bin has moved
    fitAxes();
    replot();
}

void TerrainProfileView::zoom(double factor, double x)
{
    const double middle = (axes_.left() + axes_.right()) / 2.0;
    setWindow(axes_.zoom() * factor, axes_.shift() + (x - middle) * (1.0 - factor));
    showWindow();
}

void TerrainProfileView::pan(double metres)
{
    setWindow(axes_.zoom(), axes_.shift() + metres);
    showWindow();
}

void TerrainProfileView::resetZoom()
{
    axes_.setWindow(1.0, 0.0);
    showWindow();
}

/// Zooms and pans by the mouse. Returns true if that is all that the event does.
bool TerrainProfileView::navigate(QEvent& event)
{
    if (!remembered_ || (remembered_->strip().isEmpty() && !isZoomed())) return false;
    if (event.type() == QEvent::Wheel) {
        const auto& wheel = static_cast<QWheelEvent&>(event);
        constexpr double kNotch = 120.0;
        zoom(std::pow(kStepOfZoom, -wheel.angleDelta().y() / kNotch),
             pointAt(wheel.position()).x());
        event.accept();
        return true;
    }
    if (event.type() == QEvent::MouseButtonDblClick && isZoomed()) {
        resetZoom();
        return true;
    }
    if (event.type() == QEvent::MouseButtonPress) {
        const auto& press = static_cast<QMouseEvent&>(event);
        if (press.button() == Qt::LeftButton) dragged_ = pointAt(press.position()).x();
    }
    if (event.type() == QEvent::MouseButtonRelease || event.type() == QEvent::Leave)
        dragged_.reset();
    if (event.type() == QEvent::MouseMove && dragged_) {
        pan(*dragged_ - pointAt(static_cast<QMouseEvent&>(event).position()).x());
        return true;
    }
    return false;
}

bool TerrainProfileView::navigateByKey(const QKeyEvent& event)
{
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    const double middle = (axes_.left() + axes_.right()) / 2.0;
    const double quarter = (axes_.right() - axes_.left()) / 4.0;
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoom(1.0 / kStepOfZoom, middle); return true;
    case Qt::Key_Minus: zoom(kStepOfZoom, middle); return true;
    case Qt::Key_0: resetZoom(); return true;
    case Qt::Key_Left:
        if (shift) pan(-quarter);
        return shift;
    case Qt::Key_Right:
        if (shift) pan(quarter);
        return shift;
    default: return false;
    }
}

}  // namespace terratact
