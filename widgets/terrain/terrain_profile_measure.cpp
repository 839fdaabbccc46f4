#include <QCoreApplication>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/display/format.h"
#include "app/display/place_text.h"
#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/measured_line.h"
#include "widgets/terrain/provenance_text.h"
#include "widgets/terrain/remembered_layer.h"
#include "widgets/terrain/terrain_profile_view.h"
#include "widgets/terrain/touch_text.h"

// Measuring height and slope between two points of the picture.

namespace terratact {
namespace {

constexpr int kMagnet = 16;  // [px at 100 %] an end nearer to the ground stands on it

/// Returns an end on a bin of an estimate.
MeasuredEnd groundOf(const TerrainEstimate& e, int bin)
{
    const auto i = static_cast<std::size_t>(bin);
    MeasuredEnd end{
        .at = {binCentre(bin), e.height[i]}, .sd = e.sd[i], .word = touchWord(e.touch[i])};
    const Provenance from = provenance(e, bin);
    const bool isFelt = e.touch[i] == Touch::Felt || e.touch[i] == Touch::FeltInPart
                     || (e.touch[i] == Touch::Unrecorded && from != Provenance::PriorOnly);
    if (e.touch[i] == Touch::Unrecorded) end.word = provenanceWord(from);
    if (isFelt && drawable(end.at) && std::isfinite(end.sd)) end.kind = MeasuredEnd::Kind::Felt;
    return end;
}

/// Returns an end on remembered ground.
MeasuredEnd groundOf(const SeenBin& bin)
{
    MeasuredEnd end{.at = {bin.x, bin.band.height}, .sd = bin.band.sd};
    if (bin.felt == FeltBy::Bounded || bin.felt == FeltBy::NotFelt) {
        end.word = touchWord(bin.felt == FeltBy::Bounded ? Touch::Bounded : Touch::NotFelt);
        return end;
    }
    end.kind = MeasuredEnd::Kind::Remembered;
    end.word = TerrainProfileView::tr("remembered");
    return end;
}

}  // namespace

/// Returns the ground at x [m]: of the estimate, else remembered; else an end that is not felt.
MeasuredEnd TerrainProfileView::groundAt(double x) const
{
    if (estimate_)
        if (const auto bin = binOf(x)) return groundOf(*full(), *bin);
    const auto& drawn = remembered_->drawn();
    const Side side = shownSides_ == ShownSides::Left  ? Side::Left
                    : shownSides_ == ShownSides::Right ? Side::Right
                                                       : fullSide_;
    const double half = (binEnd(0) - binBegin(0)) / 2.0;
    for (const SeenBin& bin : drawn[drawn[1].empty() ? 0 : indexOf(side)])
        if (std::abs(bin.x - x) <= half) return groundOf(bin);
    return {.at = {x, std::numeric_limits<double>::quiet_NaN()}, .word = touchWord(Touch::NotFelt)};
}

/// Returns the end that a point of the picture means: the ground near it, or the point itself above felt ground.
TerrainProfileView::PictureEnd TerrainProfileView::endNear(QPointF at) const
{
    const MeasuredEnd ground = groundAt(at.x());
    if (!ground.isKnown()) return {at, true};
    const bool isNear =
        std::abs(pixelOf(0.0, at.y()).y() - pixelOf(0.0, ground.at.y()).y()) <= scaled(kMagnet);
    return {at, isNear};
}

/// Returns an end as it is now, with the present estimate.
MeasuredEnd TerrainProfileView::measuredEnd(const PictureEnd& end) const
{
    MeasuredEnd ground = groundAt(end.at.x());
    if (!ground.isKnown()) {
        if (!drawable(ground.at)) ground.at = end.at;
        return ground;
    }
    if (end.isOnGround) return ground;
    return {.at = end.at, .kind = MeasuredEnd::Kind::Free, .word = tr("free point")};
}

void TerrainProfileView::setMeasuring(bool on)
{
    if (on == measures_) return;
    measures_ = on;
    const int bin = inspector_->bin() < 0 ? kFirstAhead : inspector_->bin();
    const double x = remembered_->isShown() && !estimate_ ? 0.0 : binCentre(bin);
    ends_[0] = ends_[1] = {{x, 0.0}, true};
    inspect(std::nullopt);
    showMeasurement();
    describe();
    replot();
    emit measuringChanged(on);
}

QStringList TerrainProfileView::measuredLines() const
{
    return measures_ ? measuredText(measuredEnd(ends_[0]), measuredEnd(ends_[1])) : QStringList{};
}

/// Shows the measurement, and how much closer the picture is shown.
void TerrainProfileView::showMeasurement()
{
    measured_->ends.reset();
    measured_->lines.clear();
    if (axes_.zoom() < 1.0)
        measured_->lines
            << tr("%1 times closer (0: all)").arg(format::number(1.0 / axes_.zoom(), 1));
    if (!measures_) return;
    measured_->ends = {measuredEnd(ends_[0]), measuredEnd(ends_[1])};
    if (ends_[0].at == ends_[1].at) {
        measured_->lines << tr("measuring: drag, or ← → (Enter: begin here)");
        return;
    }
    QStringList lines = measuredLines();
    if (const auto side = sideInFull()) lines[0].prepend(sideWord(*side) + QStringLiteral(" · "));
    measured_->lines << lines;
}

/// Moves the second end to the next bin. Returns true if the key does nothing else.
bool TerrainProfileView::measureByKey(const QKeyEvent& event)
{
    if (!measures_) return false;
    const double step = binEnd(0) - binBegin(0);
    double x = ends_[1].at.x();
    switch (event.key()) {
    case Qt::Key_Left: x -= step; break;
    case Qt::Key_Right: x += step; break;
    case Qt::Key_Return:
    case Qt::Key_Enter: ends_[0] = ends_[1]; break;
    default: return false;
    }
    ends_[1] = {{std::clamp(x, axes_.left(), axes_.right()), 0.0}, true};
    showMeasurement();
    describe();
    replot();
    return true;
}

}  // namespace terratact
