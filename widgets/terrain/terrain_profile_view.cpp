#include "widgets/terrain/terrain_profile_view.h"

#include <qwt_interval_symbol.h>
#include <qwt_legend_label.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_intervalcurve.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_shapeitem.h>
#include <qwt_plot_textlabel.h>
#include <qwt_scale_map.h>
#include <qwt_symbol.h>
#include <qwt_text.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/infer/verdict/verdict.h"
#include "display/format.h"
#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_plot.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/profile_layers.h"
#include "widgets/terrain/provenance_marks.h"
#include "widgets/terrain/provenance_text.h"
#include "widgets/terrain/terrain_items.h"
#include "widgets/terrain/touch_text.h"

namespace terratact {
namespace {

// [m] limits to which the view grows for outlying heights.
constexpr double kLowest = -1.6, kHighest = 1.2;

QwtSymbol* symbol(QwtSymbol::Style style, const QColor& line, const QColor& fill, int size)
{
    return new QwtSymbol(style, fill, QPen(line, 2.0), QSize(size, size));
}

/// Sets a text at the top of the canvas.
void setLabel(QwtPlotTextLabel& label, QwtText words)
{
    words.setRenderFlags(Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap);
    QColor behind = theme().card;
    behind.setAlpha(0xe0);
    words.setBackgroundBrush(behind);
    label.setText(words);
    label.setVisible(!words.text().isEmpty());
}

constexpr int kNoteMargin = 12;  // [px]
constexpr int kLowPlot = 230;    // [px] below this height a plot is low

/// Returns the mean standard deviation [m] over the bins that the ghost has.
double meanSd(const Ghost& ghost)
{
    double sum = 0.0;
    int bins = 0;
    for (const auto& bin : ghost.bin) {
        if (!bin) continue;
        sum += bin->sd;
        ++bins;
    }
    return bins > 0 ? sum / bins : 0.0;
}

void setInLegend(QwtPlotItem& item, bool shown)
{
    if (item.testItemAttribute(QwtPlotItem::Legend) != shown)
        item.setItemAttribute(QwtPlotItem::Legend, shown);
}

}  // namespace

TerrainProfileView::TerrainProfileView(QWidget* parent)
    : QwtPlot(parent), axes_(*this), robot_(*this)
{
    setAccessibleName(tr("Terrain profile"));
    makePlain(*this);
    canvas()->installEventFilter(this);
    setAutoFillBackground(false);

    auto* key = new Key(*this);
    key->setFrameStyle(QFrame::NoFrame);
    insertLegend(key, QwtPlot::BottomLegend);

    (new BandKey)->attach(this);
    zones_ = new BinZones;
    zones_->attach(this);

    grid_ = new QwtPlotGrid;
    grid_->enableX(false);
    grid_->setZ(0.5);
    grid_->attach(this);
    (new BinBorders)->attach(this);

    const auto line = [this](double z, const QString& name) {
        auto* item = new LineItem(name);
        item->setBrush(Qt::NoBrush);
        item->setRenderHint(QwtPlotItem::RenderAntialiased);
        item->setItemAttribute(QwtPlotItem::Legend, !name.isEmpty());
        item->setZ(z);
        item->attach(this);
        return item;
    };
    ceilings_ = line(12.0, tr("ceiling"));
    meanPrior_ = line(20.0, {});
    mean_ = line(21.0, {});
    truthLine_ = line(19.0, tr("truth"));

    for (const Provenance from : {Provenance::Contact, Provenance::Arm, Provenance::Constrained,
                                  Provenance::Sampled, Provenance::PriorOnly}) {
        const auto kind = static_cast<std::size_t>(from);
        auto* bar = new QwtPlotIntervalCurve;
        bar->setStyle(QwtPlotIntervalCurve::NoCurve);
        bar->setItemAttribute(QwtPlotItem::Legend, false);
        bar->setZ(24.0);
        bar->attach(this);
        bars_[kind] = bar;

        auto* points = new MarkCurve(from);
        points->setZ(26.0);
        points->attach(this);
        points_[kind] = points;
    }

    letters_ = new MarkLetters;
    letters_->attach(this);

    imu_ = new QwtPlotMarker;
    imu_->setValue(0.0, 0.0);
    imu_->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    imu_->setSpacing(6);
    imu_->setRenderHint(QwtPlotItem::RenderAntialiased);
    imu_->setZ(15.0);
    imu_->attach(this);

    armMark_ = new ArmMark(*zones_);
    armMark_->setVisible(false);
    armMark_->attach(this);

    draws_ = new SampleLines;
    draws_->attach(this);
    second_ = new SecondEstimate;
    second_->attach(this);
    twoHeights_ = new TwoHeights;
    twoHeights_->attach(this);
    ghost_ = new GhostLayer;
    ghost_->attach(this);
    staleOverlay_ = new StaleOverlay;
    staleOverlay_->attach(this);
    for (QwtPlotItem* layer : std::initializer_list<QwtPlotItem*>{draws_, second_, ghost_})
        layer->setItemAttribute(QwtPlotItem::Legend,
                                false);  // no legend entry until there is something to show
    inspector_ = new BinInspector(this);
    setFocusPolicy(Qt::TabFocus);
    canvas()->setMouseTracking(true);

    const auto label = [this] {
        auto* item = new Note;
        item->setItemAttribute(QwtPlotItem::Legend, false);
        item->setZ(40.0);
        item->attach(this);
        return item;
    };
    note_ = label();
    ghostNote_ = label();

    clearEstimate(tr("No estimate yet"));
    showTruth();
    restyle();
}

void TerrainProfileView::restyle()
{
    setCanvasBackground(theme().card);
    axes_.restyle();
    grid_->setMajorPen(theme().grid, 1.0);

    ceilings_->setPen(QPen(theme().ceiling, 1.5, Qt::DotLine));
    QPen soft(theme().sampled, 2.5, Qt::CustomDashLine, Qt::RoundCap, Qt::RoundJoin);
    soft.setDashPattern({2.5, 2.5});
    meanPrior_->setPen(soft);
    mean_->setPen(QPen(theme().sampled, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    truthLine_->setPen(QPen(theme().truth, 1.2));

    for (const Provenance from : kProvenances) {
        const auto kind = static_cast<std::size_t>(from);
        const ProvenanceMark mark = markOf(from);
        bars_[kind]->setSymbol(new PatternBar(mark.bar));
        points_[kind]->setSymbol(symbol(mark.shape, mark.line, mark.fill, scaled(mark.size)));
    }
    imu_->setSymbol(symbol(QwtSymbol::Ellipse, theme().text, theme().text, scaled(7)));
    imu_->setLabel(inked(tr("IMU"), theme().muted, sized(font(), 12)));
    showNote(note_->text().text(), estimate_.has_value());
    showGhostNote(ghostNote_->text().text());
    robot_.restyle();
    for (QwtPlotItem* item : itemList()) item->legendChanged();
    sizeLegend();
    replot();
}

void TerrainProfileView::sizeLegend()
{
    const QFont small = sized(font(), 13);
    for (QWidget* label : legend()->findChildren<QwtLegendLabel*>()) label->setFont(small);
}

void TerrainProfileView::changeEvent(QEvent* event)
{
    QwtPlot::changeEvent(event);
    // Restyles later, because the style sheet sets the palettes of the parts after this event.
    if (event->type() == QEvent::StyleChange) QTimer::singleShot(0, this, [this] { restyle(); });
}

void TerrainProfileView::setEstimate(const TerrainEstimate& estimate, const QString& note)
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

void TerrainProfileView::showNote(const QString& note, bool warns)
{
    setLabel(*note_, inked(note, warns ? theme().doubt : theme().muted, sized(font(), 16, true)));
    arrangeNotes();
}

void TerrainProfileView::showGhostNote(const QString& note)
{
    setLabel(*ghostNote_,
             inked(note, ghost_->ghost ? theme().sampled : theme().muted, sized(font(), 15, true)));
    arrangeNotes();
}

void TerrainProfileView::arrangeNotes()
{
    // In a low plot two lines would cover the robot. Beside a ghost the movement note is less important.
    const bool isLow = canvas()->height() < scaled(kLowPlot) && ghost_->ghost;
    note_->setVisible(!isLow && !note_->text().text().isEmpty());
    note_->setMargin(zones_->isShown() ? scaled(28) : kNoteMargin);  // below the zones' words
    ghostNote_->setMargin(isLow ? kNoteMargin : scaled(40));  // otherwise below the other note
}

void TerrainProfileView::resizeEvent(QResizeEvent* event)
{
    axes_.name();
    QwtPlot::resizeEvent(event);
    arrangeNotes();
}

void TerrainProfileView::setGhost(const std::optional<Ghost>& ghost, const QString& why)
{
    const QString note = ghost
                           ? tr("ghost of the last estimate · %1 m driven since · heights ± %2 cm")
                                 .arg(format::number(ghost->motion.way, 2),
                                      format::number(100.0 * meanSd(*ghost), 0))
                           : why;
    if (ghost == ghost_->ghost && note == ghostNote_->text().text()) return;
    const bool comesOrGoes = ghost.has_value() != ghost_->ghost.has_value();
    ghost_->ghost = ghost;
    setInLegend(*ghost_, ghost.has_value());
    if (comesOrGoes) {
        sizeLegend();
        QTimer::singleShot(0, this,
                           [this] { updateLayout(); });  // after the legend has laid out its lines
    }
    showGhostNote(note);
    describe();
    fitAxes();
    replot();
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
    std::array<QVector<QPointF>, kKinds> points;
    std::array<QVector<QwtIntervalSample>, kKinds> bars;
    std::vector<QPointF> known, prior;
    QPainterPath ceilings;
    zones_->shown.fill(false);
    zones_->touch = estimate_ ? estimate_->touch : unrecordedTouch();
    zones_->horizon = estimate_ ? feltHorizon(*estimate_) : std::nullopt;
    letters_->shown = {};
    if (estimate_) {
        const TerrainEstimate& e = *estimate_;
        constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
        for (int bin = 0; bin < kBins; ++bin) {
            const auto i = static_cast<std::size_t>(bin);
            const Provenance from = provenance(e, bin);
            const auto kind = static_cast<std::size_t>(from);
            const QPointF point(binCentre(bin), e.height[i]);
            if (drawable(point)) {
                points[kind].append(point);
                letters_->shown[i] = from;
            }
            const bool unfelt = isUnfeltAhead(e, bin);  // no band, because it would look measured
            if (!unfelt && drawable(e.q10[i]) && drawable(e.q90[i]) && e.q10[i] <= e.q90[i])
                bars[kind].append(QwtIntervalSample(point.x(), e.q10[i], e.q90[i]));
            if (drawable(e.ceiling[i])) {
                ceilings.moveTo(binBegin(bin), e.ceiling[i]);
                ceilings.lineTo(binEnd(bin), e.ceiling[i]);
            }
            zones_->shown[i] = unfelt;

            // A segment that touches a prior-only bin is dashed.
            known.push_back(e.priorOnly(bin) ? QPointF(point.x(), kNowhere) : point);
            if (bin > 0) {
                const bool soft = e.priorOnly(bin) || e.priorOnly(bin - 1);
                prior.push_back(soft ? QPointF(binCentre(bin - 1), e.height[i - 1])
                                     : QPointF(point.x(), kNowhere));
                prior.push_back(soft ? point : QPointF(point.x(), kNowhere));
                prior.emplace_back(point.x(), kNowhere);
            }
        }
    }
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        points_[kind]->setSamples(points[kind]);
        bars_[kind]->setSamples(bars[kind]);
    }
    twoHeights_->modes = estimate_ ? twoModes(*estimate_) : decltype(twoHeights_->modes){};
    const bool two = std::any_of(twoHeights_->modes.begin(), twoHeights_->modes.end(),
                                 [](const auto& modes) { return modes.has_value(); });
    setInLegend(*twoHeights_, two);
    arrangeNotes();
    showDraws();
    inspect(inspector_->bin() >= 0 ? std::optional(inspector_->bin()) : std::nullopt);
    mean_->setShape(pathThrough(known));
    meanPrior_->setShape(pathThrough(prior));
    ceilings_->setShape(ceilings);
    showArm();
    describe();
}

void TerrainProfileView::showDraws()
{
    draws_->draws.clear();
    if (estimate_ && drawsShown_) draws_->draws = estimate_->draws;
    setInLegend(*draws_, !draws_->draws.empty());
}

void TerrainProfileView::setDrawsShown(bool shown)
{
    if (shown == drawsShown_) return;
    drawsShown_ = shown;
    showDraws();
    replot();
}

void TerrainProfileView::setSecond(const std::optional<TerrainEstimate>& estimate,
                                   const QString& name)
{
    if (estimate == second_->estimate) return;
    second_->estimate = estimate;
    second_->setTitle(name);
    setInLegend(*second_, estimate.has_value());
    fitAxes();
    replot();
}

void TerrainProfileView::inspect(std::optional<int> bin)
{
    if (!estimate_ || !bin) return inspector_->clear();
    inspector_->setBin(*estimate_, *bin, closeUp(*bin));
    // The inspector stands beside the bin, so that it does not hide it.
    const QPoint at = canvas()->mapTo(this, pixelOf(binEnd(*bin), 0.0).toPoint());
    const int width = inspector_->width();
    const bool right = at.x() + 8 + width < this->width();
    const int left =
        right ? at.x() + 8
              : canvas()->mapTo(this, pixelOf(binBegin(*bin), 0.0).toPoint()).x() - 8 - width;
    inspector_->move(std::max(0, left), canvas()->y() + 8);
    inspector_->raise();
}

QStringList TerrainProfileView::closeUp(int bin) const
{
    const TerrainEstimate& e = *estimate_;
    const auto i = static_cast<std::size_t>(bin);
    QStringList lines{
        tr("bin %1").arg(format::binName(bin)),
        tr("height %1 m ± %2 m")
            .arg(format::signedNumber(e.height[i], 3), format::number(e.sd[i], 3)),
        tr("80 % in %1 … %2 m")
            .arg(format::signedNumber(e.q10[i], 3), format::signedNumber(e.q90[i], 3)),
        e.ceiling[i] < kDrawableLimit
            ? tr("ceiling %1 m").arg(format::signedNumber(e.ceiling[i], 3))
            : tr("nothing of the robot above it"),
        tr("from: %1 (%2)")
            .arg(provenanceWord(provenance(e, bin)), provenanceLetter(provenance(e, bin))),
        tr("touch: %1").arg(touchWord(e.touch[i]))};
    if (const auto& two = twoHeights_->modes[i])
        lines << tr("either %1 m (%2 %)")
                     .arg(format::signedNumber(two->lowMean, 2),
                          format::number(100.0 * two->lowShare, 0))
              << tr("or %1 m (%2 %)")
                     .arg(format::signedNumber(two->highMean, 2),
                          format::number(100.0 * two->highShare, 0));
    return lines;
}

void TerrainProfileView::setOutline(const Outline& outline)
{
    robot_.setOutline(outline);
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
    return drawable(estimate_->q90[i]) ? std::max(estimate_->q90[i], estimate_->height[i])
                                       : estimate_->height[i];
}

void TerrainProfileView::showArm()
{
    const bool inBins = armTip_ && armTip_->bin >= 0 && armTip_->bin < kBins;
    const bool shown = inBins && drawable(underArm());
    if (shown) {
        armMark_->state = armTip_->state;
        armMark_->at = binCentre(armTip_->bin);
        armMark_->down = underArm();
    }
    armMark_->setVisible(shown);
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
}

bool TerrainProfileView::setScales()
{
    double bottom = ProfileAxes::kBottom, top = ProfileAxes::kTop;
    const auto include = [&](double z) {
        if (!drawable(z)) return;
        bottom = std::min(bottom, std::max(kLowest, z - 0.03));
        top = std::max(top, std::min(kHighest, z + 0.06));
    };
    if (estimate_) {
        for (std::size_t i = 0; i < kBins; ++i) {
            for (const double z : {estimate_->height[i], estimate_->q10[i], estimate_->q90[i]})
                include(z);
        }
    }
    if (truth_) {
        for (const double z : *truth_) include(z);
    }
    if (second_
        && second_
               ->estimate) {  // the legend triggers a layout before the second estimate is complete
        for (const double z : second_->estimate->height) include(z);
    }
    if (ghost_ && ghost_->ghost) {  // the same holds for the ghost
        for (const auto& bin : ghost_->ghost->bin) {
            if (!bin) continue;
            for (const double z : {bin->height, bin->q10, bin->q90}) include(z);
        }
    }
    return axes_.fit(bottom, top, MarkLetters::reserved(font(), canvas()->height()));
}

QPointF TerrainProfileView::pixelOf(double x, double z) const
{
    return {canvasMap(QwtPlot::xBottom).transform(x), canvasMap(QwtPlot::yLeft).transform(z)};
}

QPointF TerrainProfileView::pointAt(QPointF pixel) const
{
    return {canvasMap(QwtPlot::xBottom).invTransform(pixel.x()),
            canvasMap(QwtPlot::yLeft).invTransform(pixel.y())};
}

QString TerrainProfileView::binText(int bin) const
{
    if (!estimate_ || bin < 0 || bin >= kBins) return {};
    const auto i = static_cast<std::size_t>(bin);
    const Touch touch = estimate_->touch[i];
    const bool recorded = touch != Touch::Unrecorded;
    if (recorded && isUnfeltAhead(*estimate_, bin))
        return tr("bin %1: %2").arg(format::binName(bin), touchWord(touch));
    const QString known =
        tr("bin %1: %2 m, 80 % in %3 … %4, %5")
            .arg(format::binName(bin), format::signedNumber(estimate_->height[i], 2),
                 format::signedNumber(estimate_->q10[i], 2),
                 format::signedNumber(estimate_->q90[i], 2),
                 provenanceWord(provenance(*estimate_, bin)));
    return recorded ? known + QStringLiteral(", ") + touchWord(touch) : known;
}

void TerrainProfileView::describe()
{
    QStringList lines;
    for (int bin = 0; bin < kBins && estimate_; ++bin) lines << binText(bin);
    if (const QString note = note_->text().text(); !note.isEmpty()) lines.prepend(note);
    if (!staleOverlay_->words.isEmpty())
        lines.prepend(tr("not live: nothing is heard of the robot"));
    if (!ghostNote_->text().text().isEmpty()) lines << ghostNote_->text().text();
    setAccessibleDescription(lines.join(QLatin1Char('\n')));
}

bool TerrainProfileView::eventFilter(QObject* object, QEvent* event)
{
    if (object == canvas() && event->type() == QEvent::MouseMove)
        inspect(binOf(pointAt(static_cast<QMouseEvent*>(event)->position()).x()));
    if (object == canvas() && event->type() == QEvent::MouseButtonDblClick) {
        const auto* click = static_cast<QMouseEvent*>(event);
        const std::optional<int> bin = binOf(pointAt(click->position()).x());
        if (bin && click->button() == Qt::LeftButton) emit binChosen(*bin);
    }
    if (object == canvas() && event->type() == QEvent::Leave) inspect(std::nullopt);
    return QwtPlot::eventFilter(object, event);
}

void TerrainProfileView::keyPressEvent(QKeyEvent* event)
{
    const int now = inspector_->bin();
    if (event->key() == Qt::Key_Right) return inspect(now < 0 ? 0 : std::min(now + 1, kBins - 1));
    const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enters && now >= 0) return void(emit binChosen(now));
    if (event->key() == Qt::Key_Left) return inspect(now < 0 ? kBins - 1 : std::max(now - 1, 0));
    QwtPlot::keyPressEvent(event);
}

void TerrainProfileView::focusOutEvent(QFocusEvent* event)
{
    inspect(std::nullopt);
    QwtPlot::focusOutEvent(event);
}

}  // namespace terratact
