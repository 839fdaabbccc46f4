#include "widgets/terrain/terrain_profile_view.h"

#include <qwt_plot_curve.h>
#include <qwt_plot_intervalcurve.h>
#include <qwt_plot_shapeitem.h>
#include <qwt_plot_textlabel.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/display/format.h"
#include "app/display/place_text.h"
#include "core/infer/verdict/verdict.h"
#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/earlier_layer.h"
#include "widgets/terrain/profile_layers.h"
#include "widgets/terrain/provenance_marks.h"
#include "widgets/terrain/remembered_layer.h"
#include "widgets/terrain/terrain_items.h"

namespace terratact {
namespace {

// [m] limits to which the view grows for outlying heights.
constexpr double kLowest = -1.6, kHighest = 1.2;

constexpr int kNoteMargin = 12;  // [px]
constexpr int kLowPlot = 230;    // [px] below this height a plot is low

/// Returns true if all points of the outline up to x = right lie below `bottom` [m].
bool isOutlineBelow(const Outline& outline, double right, double bottom)
{
    return std::ranges::all_of(outline, [&](const OutlinePart& part) {
        return std::ranges::all_of(part.points, [&](const std::array<double, 2>& point) {
            return !drawable(point[1]) || point[0] > right || point[1] < bottom;
        });
    });
}

void setInLegend(QwtPlotItem& item, bool shown)
{
    if (item.testItemAttribute(QwtPlotItem::Legend) != shown)
        item.setItemAttribute(QwtPlotItem::Legend, shown);
}

}  // namespace

void TerrainProfileView::setEstimate(const TwoTrackEstimate& estimate, const QString& note)
{
    estimate_ = estimate;
    showNote(note, true);
    showEstimate();
}

void TerrainProfileView::clearEstimate(const QString& why)
{
    estimate_.reset();
    showNote(why, false);
    showEstimate();
}

void TerrainProfileView::setContacts(std::vector<ContactPoint> points)
{
    if (!contacts_->setPoints(std::move(points))) return;
    describe();
    replot();
}

void TerrainProfileView::showNote(const QString& note, bool warns)
{
    setLabel(*note_, inked(note, warns ? theme().warning : theme().muted, sized(font(), 16, true)));
    arrangeNotes();
}

QString TerrainProfileView::note() const
{
    return note_->text().text();
}

/// Returns how far a note at the top reaches down [px]; in a narrow plot it has several lines.
int TerrainProfileView::bottomOf(const QwtPlotTextLabel& note) const
{
    if (!note.isVisible()) return 0;
    const int margin = note.margin();
    const double width = canvas()->contentsRect().width() - 2.0 * margin;
    return margin + static_cast<int>(std::ceil(note.text().heightForWidth(width, font())));
}

void TerrainProfileView::arrangeNotes()
{
    // In a low plot two lines would cover the robot. Beside remembered ground the movement note is less important.
    const bool isLow =
        canvas()->height() < scaled(kLowPlot) && remembered_->isShown() && !estimate_;
    note_->setVisible(!isLow && !note_->text().text().isEmpty());
    note_->setMargin(zones_->isShown() ? scaled(28) : kNoteMargin);  // below the zones' words
    rememberedNote_->setMargin(isLow ? kNoteMargin : std::max(scaled(40), bottomOf(*note_)));
    placeCorner();
}

void TerrainProfileView::setCorner(QWidget* corner)
{
    corner_ = corner;
    corner_->setParent(this);
    corner_->setAttribute(Qt::WA_TransparentForMouseEvents);
    placeCorner();
}

void TerrainProfileView::placeCorner()
{
    if (!corner_) return;
    constexpr int kGap = 4;                  // [px]
    constexpr double kMinWidthShare = 0.72;  // least share of its width
    const QRect frame = canvas()->geometry().adjusted(kGap, kGap, -kGap, -kGap);
    const int bins = canvas()->x() + static_cast<int>(pixelOf(binBegin(0), 0.0).x()) - kGap;
    const QSize wanted = corner_->sizeHint(), flat = corner_->minimumSizeHint();
    const QSize free(bins - frame.left(), frame.height());
    const bool isBeside =
        free.width() >= kMinWidthShare * wanted.width() && free.height() >= wanted.height();
    const QSize size = isBeside ? wanted.boundedTo(free) : flat;
    const bool isCovered = std::ranges::any_of(std::array{note_, rememberedNote_}, [&](auto* note) {
        const double half = note->text().textSize(font()).width() / 2.0;
        return note->isVisible() && frame.center().x() - half < frame.left() + size.width();
    });
    const QRect place(frame.topLeft(), size);
    corner_->setGeometry(place);
    corner_->setVisible(!isCovered && (isBeside || isFreeAbove(place)));
}

/// Returns true if nothing is drawn at a place at the top, above the bins under the robot's tracks.
bool TerrainProfileView::isFreeAbove(const QRect& place) const
{
    const QPoint corner = canvas()->geometry().topLeft();
    const double right = pointAt(place.topRight() - corner).x();
    const double bottom = pointAt(place.bottomLeft() - corner).y();
    if (!canvas()->geometry().contains(place) || right > binBegin(kFirstAhead)) return false;
    const auto isBelow = [bottom](double z) { return !drawable(z) || z < bottom; };
    for (int bin = 0; bin < kBins && binBegin(bin) < right; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        for (const TerrainEstimate* e : {full(), light()})
            if (e && !(isBelow(e->q90[i]) && isBelow(e->height[i]))) return false;
        if (truth_ && !isBelow((*truth_)[i])) return false;
        if (second_->estimate && !isBelow(second_->estimate->height[i])) return false;
    }
    for (const auto& bins : remembered_->drawn())
        for (const SeenBin& bin : bins)
            if (bin.x >= axes_.left() && bin.x < right && !isBelow(bin.band.q90)) return false;
    for (const QPointF& point : earlier_->within(axes_.left(), right))
        if (!isBelow(point.y())) return false;
    return isOutlineBelow(robot_.outline(), right, bottom)
        && isOutlineBelow(farRobot_.outline(), right, bottom);
}

void TerrainProfileView::resizeEvent(QResizeEvent* event)
{
    axes_.name();
    QwtPlot::resizeEvent(event);
    arrangeNotes();
}

void TerrainProfileView::setStale(std::optional<double> age)
{
    const QString words = age ? tr("as of %1 ago").arg(format::age(*age)) : QString();
    if (words == staleOverlay_->words) return;
    const bool turns = words.isEmpty() != staleOverlay_->words.isEmpty();
    staleOverlay_->words = words;
    if (turns) describe();
    replot();
}

void TerrainProfileView::showEstimate()
{
    showBins(estimate_ ? *full() : TerrainEstimate{});
    showSides();
    const TerrainEstimate* const shown = full();
    showRemembered();
    twoHeights_->modes = shown ? twoModes(*shown) : decltype(twoHeights_->modes){};
    const bool two = std::any_of(twoHeights_->modes.begin(), twoHeights_->modes.end(),
                                 [](const auto& modes) { return modes.has_value(); });
    setInLegend(*twoHeights_, two);
    arrangeNotes();
    showDraws();
    showSecond();
    inspect(inspector_->bin() >= 0 ? std::optional(inspector_->bin()) : std::nullopt);
    showMeasurement();
    showArm();
    describe();
}

/// Sets the marks, bars and lines of the side in full; without an estimate they are empty.
void TerrainProfileView::showBins(const TerrainEstimate& e)
{
    std::array<QVector<QPointF>, kKinds> points;
    std::array<std::vector<MarkFill>, kKinds> fills;
    std::array<QVector<QwtIntervalSample>, kKinds> bars;
    std::vector<QPointF> known, prior;
    QPainterPath ceilings;
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    for (int bin = 0; bin < kBins && estimate_; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        const auto kind = static_cast<std::size_t>(provenance(e, bin));
        const QPointF point(binCentre(bin), e.height[i]);
        if (drawable(point)) {
            points[kind].append(point);
            fills[kind].push_back(markFill(e, bin));
        }
        const bool unfelt = isUnfeltAhead(e, bin);  // no band, because it would look measured
        if (!unfelt && drawable(e.q10[i]) && drawable(e.q90[i]) && e.q10[i] <= e.q90[i])
            bars[kind].append(QwtIntervalSample(point.x(), e.q10[i], e.q90[i]));
        if (drawable(e.ceiling[i])) {
            ceilings.moveTo(binBegin(bin), e.ceiling[i]);
            ceilings.lineTo(binEnd(bin), e.ceiling[i]);
        }
        // A segment that touches a prior-only bin is dashed.
        known.push_back(e.priorOnly(bin) ? QPointF(point.x(), kNowhere) : point);
        if (bin == 0) continue;
        const bool soft = e.priorOnly(bin) || e.priorOnly(bin - 1);
        prior.push_back(soft ? QPointF(binCentre(bin - 1), e.height[i - 1])
                             : QPointF(point.x(), kNowhere));
        prior.push_back(soft ? point : QPointF(point.x(), kNowhere));
        prior.emplace_back(point.x(), kNowhere);
    }
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        points_[kind]->setMarks(points[kind], std::move(fills[kind]));
        bars_[kind]->setSamples(bars[kind]);
    }
    for (QwtPlotShapeItem* line : {mean_, meanCore_}) line->setShape(pathThrough(known));
    for (QwtPlotShapeItem* line : {meanPrior_, meanPriorCore_}) line->setShape(pathThrough(prior));
    ceilings_->setShape(ceilings);
}

void TerrainProfileView::showDraws()
{
    draws_->draws.clear();
    if (estimate_ && drawsShown_) draws_->draws = full()->draws;
    setInLegend(*draws_, !draws_->draws.empty());
}

void TerrainProfileView::setDrawsShown(bool shown)
{
    if (shown == drawsShown_) return;
    drawsShown_ = shown;
    showDraws();
    replot();
}

void TerrainProfileView::setSecond(const std::optional<TwoTrackEstimate>& estimate,
                                   const QString& name)
{
    if (estimate == secondEstimate_) return;
    secondEstimate_ = estimate;
    showSecond();
    second_->setTitle(name);
    setInLegend(*second_, estimate.has_value());
    fitAxes();
    replot();
}

void TerrainProfileView::setOutline(const Outline& outline, const Outline& far)
{
    if (outline == robot_.outline() && far == farRobot_.outline()) return;
    robot_.setOutline(outline);
    farRobot_.setOutline(far);
    fitAxes();
    replot();
}

void TerrainProfileView::setTruth(const std::optional<Heights>& truth)
{
    if (truth == truth_) return;
    truth_ = truth;
    showTruth();
    fitAxes();
    replot();
}

void TerrainProfileView::showTruth()
{
    // The truth is a mean per bin, drawn as a level line over each bin so that steps stay visible.
    std::vector<QPointF> line;
    if (truth_) {
        for (int bin = 0; bin < kBins; ++bin) {
            line.emplace_back(binBegin(bin), (*truth_)[static_cast<std::size_t>(bin)]);
            line.emplace_back(binEnd(bin), (*truth_)[static_cast<std::size_t>(bin)]);
        }
    }
    truthLine_->setShape(pathThrough(line));
    setInLegend(*truthLine_, truth_.has_value());
    sizeLegend();
}

void TerrainProfileView::setArmTip(const std::optional<ArmTip>& tip)
{
    if (tip == armTip_) return;
    armTip_ = tip;
    showArm();
}

/// Returns the height under the arm's tip: the touched height, else the larger of 0.9 quantile and height.
double TerrainProfileView::underArm() const
{
    if (armTip_->state == ArmTip::State::Touched) return armTip_->height;
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    if (!estimate_) return kNowhere;
    const auto i = static_cast<std::size_t>(armTip_->bin);
    const TerrainEstimate& e = armTip_->side == ProbeSide::Left  ? of(Side::Left)
                             : armTip_->side == ProbeSide::Right ? of(Side::Right)
                                                                 : *full();
    return drawable(e.q90[i]) ? std::max(e.q90[i], e.height[i]) : e.height[i];
}

void TerrainProfileView::showArm()
{
    const bool inBins = armTip_ && armTip_->bin >= 0 && armTip_->bin < kBins;
    const bool shown = inBins && drawable(underArm());
    if (shown) {
        armMark_->state = armTip_->state;
        armMark_->at = binCentre(armTip_->bin);
        armMark_->down = underArm();
        armMark_->letter =
            armTip_->side == ProbeSide::Middle
                ? QString()
                : sideLetter(armTip_->side == ProbeSide::Left ? Side::Left : Side::Right);
    }
    armMark_->setVisible(shown);
    zones_->arm = shown ? std::optional(QPointF(armMark_->at, armMark_->down)) : std::nullopt;
    fitAxes();
    replot();
}

void TerrainProfileView::updateLayout()
{
    QwtPlot::updateLayout();
    fitAxes();
}

void TerrainProfileView::fitAxes()
{
    // New labels may need other margins, which change the size of the canvas.
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds && setScales(); ++round) QwtPlot::updateLayout();
    placeCorner();
}

bool TerrainProfileView::setScales()
{
    double bottom = ProfileAxes::kBottom, top = ProfileAxes::kTop;
    const auto include = [&](double z) {
        if (!drawable(z)) return;
        bottom = std::min(bottom, std::max(kLowest, z - 0.03));
        top = std::max(top, std::min(kHighest, z + 0.06));
    };
    for (const TerrainEstimate* e : {full(), light()}) {
        if (!e) continue;
        for (std::size_t i = 0; i < kBins; ++i)
            for (const double z : {e->height[i], e->q10[i], e->q90[i]}) include(z);
    }
    if (truth_) {
        for (const double z : *truth_) include(z);
    }
    if (second_
        && second_
               ->estimate) {  // the legend triggers a layout before the second estimate is complete
        for (const double z : second_->estimate->height) include(z);
    }
    // Close up, the heights are those of the whole picture, so that the scale does not change with the place.
    const double closer = std::max(0.0, 1.0 - axes_.zoom());
    const double beyond = closer * (ProfileAxes::kRight - ProfileAxes::kLeft) / 2.0;
    if (remembered_)  // the same holds for remembered ground
        for (const auto& bins : remembered_->drawn())
            for (const SeenBin& bin : bins) {
                if (bin.x < axes_.left() - beyond || bin.x > axes_.right() + beyond) continue;
                for (const double z : {bin.band.q10, bin.band.q90}) include(z);
            }
    if (earlier_)
        for (const QPointF& point : earlier_->within(axes_.left() - beyond, axes_.right() + beyond))
            include(point.y());
    return axes_.fit(bottom, top,
                     MarkLetters::reserved(font(), canvas()->height(), light() ? 2 : 1));
}

}  // namespace terratact
