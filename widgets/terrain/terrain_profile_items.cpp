#include <qwt_interval_symbol.h>
#include <qwt_legend_label.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_intervalcurve.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_shapeitem.h>
#include <qwt_plot_textlabel.h>
#include <qwt_symbol.h>
#include <qwt_text.h>

#include "widgets/base/palette.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/earlier_layer.h"
#include "widgets/terrain/measured_line.h"
#include "widgets/terrain/profile_layers.h"
#include "widgets/terrain/provenance_marks.h"
#include "widgets/terrain/remembered_layer.h"
#include "widgets/terrain/terrain_items.h"
#include "widgets/terrain/terrain_profile_view.h"

// The items of the plot and their look.

namespace terratact {
namespace {

QwtSymbol* symbol(QwtSymbol::Style style, const QColor& line, const QBrush& fill, int size)
{
    return new QwtSymbol(style, fill, QPen(line, 2.0), QSize(size, size));
}

}  // namespace

TerrainProfileView::TerrainProfileView(QWidget* parent)
    : PlainPlot(parent), axes_(*this), farRobot_(*this, true), robot_(*this)
{
    setAccessibleName(tr("Terrain profile"));
    canvas()->installEventFilter(this);
    setAutoFillBackground(false);

    auto* key = new Key(*this);
    key->setFrameStyle(QFrame::NoFrame);
    insertLegend(key, QwtPlot::BottomLegend);

    (new BandKey)->attach(this);
    zones_ = new BinZones;
    zones_->attach(this);
    (new ZoneWords(*zones_))->attach(this);

    grid_ = new QwtPlotGrid;
    grid_->enableX(false);
    grid_->setZ(0.5);
    grid_->attach(this);
    (new BinBorders)->attach(this);

    addLines();
    addBars();
    addMarks();
    addLayers();
    addSides();
    inspector_ = new BinInspector(this);
    setFocusPolicy(Qt::TabFocus);
    canvas()->setMouseTracking(true);
    addTouch();
    addNotes();

    clearEstimate(tr("No estimate yet"));
    showTruth();
    restyle();
}

void TerrainProfileView::addLines()
{
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
    meanPriorCore_ = line(20.5, {});
    mean_ = line(21.0, {});
    meanCore_ = line(21.5, {});
    truthLine_ = line(19.0, tr("truth"));
}

void TerrainProfileView::addBars()
{
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
}

void TerrainProfileView::addMarks()
{
    letters_ = new MarkLetters;
    letters_->attach(this);
    contacts_ = new ContactMarks;
    contacts_->attach(this);

    imu_ = new QwtPlotMarker;
    imu_->setValue(0.0, 0.0);
    // Behind the robot's middle no word of a zone ahead covers it.
    imu_->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    imu_->setSpacing(6);
    imu_->setRenderHint(QwtPlotItem::RenderAntialiased);
    imu_->setZ(15.0);
    imu_->attach(this);

    armMark_ = new ArmMark(*zones_);
    armMark_->setVisible(false);
    armMark_->attach(this);
}

void TerrainProfileView::addLayers()
{
    draws_ = new SampleLines;
    draws_->attach(this);
    second_ = new SecondEstimate;
    second_->attach(this);
    twoHeights_ = new TwoHeights;
    twoHeights_->attach(this);
    remembered_ = new RememberedLayer;
    remembered_->attach(this);
    earlier_ = new EarlierLayer;
    earlier_->attach(this);
    staleOverlay_ = new StaleOverlay;
    staleOverlay_->attach(this);
    measured_ = new MeasuredLine;
    measured_->attach(this);
    for (QwtPlotItem* layer : std::initializer_list<QwtPlotItem*>{draws_, second_, remembered_})
        layer->setItemAttribute(QwtPlotItem::Legend,
                                false);  // no legend entry until there is something to show
}

void TerrainProfileView::addNotes()
{
    const auto label = [this] {
        auto* item = new Note;
        item->setItemAttribute(QwtPlotItem::Legend, false);
        item->setZ(40.0);
        item->attach(this);
        return item;
    };
    note_ = label();
    rememberedNote_ = label();
}

void TerrainProfileView::restyle()
{
    setCanvasBackground(theme().card);
    axes_.restyle();
    grid_->setMajorPen(theme().grid, 1.0);

    ceilings_->setPen(QPen(theme().ceiling, 1.5, Qt::DotLine));
    styleSides();
    truthLine_->setPen(QPen(theme().truth, 1.2));

    for (const Provenance from : kProvenances) {
        const auto kind = static_cast<std::size_t>(from);
        const ProvenanceMark mark = markOf(from);
        bars_[kind]->setSymbol(new PatternBar(mark.bar));
        points_[kind]->setSymbol(symbol(
            mark.shape, mark.line,
            brushOf(from == Provenance::PriorOnly ? MarkFill::Open : MarkFill::Full, mark.line),
            scaled(mark.size)));
    }
    imu_->setSymbol(symbol(QwtSymbol::Ellipse, theme().text, theme().text, scaled(7)));
    imu_->setLabel(inked(tr("IMU"), theme().muted, sized(font(), 12)));
    showNote(note_->text().text(), estimate_.has_value());
    showRemembered();
    robot_.restyle();
    farRobot_.restyle();
    for (QwtPlotItem* item : itemList()) item->legendChanged();
    sizeLegend();
    replot();
}

void TerrainProfileView::sizeLegend()
{
    const QFont small = sized(font(), 13);
    for (QWidget* label : legend()->findChildren<QwtLegendLabel*>()) label->setFont(small);
}

}  // namespace terratact
