#include "app/pages/terrain_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/pages/force_arrays.h"
#include "app/pages/picture_tools.h"
#include "widgets/base/card.h"
#include "widgets/base/elided_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/drive_strip.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/readings/rear_view.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

RearView::Shape rearShapeOf(const RobotModel& robot)
{
    RearView::Shape shape{.trackY = robot.lateral.trackY,
                          .trackWidth = robot.lateral.trackWidth,
                          .flipperY = robot.lateral.flipperY,
                          .flipperWidth = robot.lateral.flipperWidth,
                          .trackBottom = robot.trackZ - robot.trackRadius,
                          .trackTop = robot.trackZ + robot.trackRadius,
                          .bodyBottom = robot.trackZ,
                          .bodyTop = robot.trackZ + robot.trackRadius,
                          .flipperPivotZ = robot.front.pivot.z,
                          .flipperPivotRadius = robot.front.pivotRadius,
                          .flipperTipRadius = robot.front.tipRadius,
                          .flipperLength = robot.front.axleDistance,
                          .flipperTaper = robot.front.taper()};
    for (const auto& polygon : robot.body)
        for (const Vec2& point : polygon) shape.bodyTop = std::max(shape.bodyTop, point.z);
    return shape;
}

}  // namespace

TerrainPage::TerrainPage(RobotModel robot, QWidget* parent)
    : QWidget(parent), robot_(std::move(robot))
{
    verdict_ = new VerdictStrip(this);
    driving_ = new DriveStrip(this);
    terrainCard_ = terrainCard();
    atem_ = new AtemPanel(this);
    probe_ = new ProbeCard(this);
    Card* const forcesCard = forceCard();
    Card* const readoutCard = robotCard();
    Card* const newsCard = eventCard();
    layout_ = new TerrainLayout(*this, {.verdict = verdict_,
                                        .driving = driving_,
                                        .terrainCard = terrainCard_,
                                        .strip = strip_,
                                        .terrain = terrain_,
                                        .atem = atem_,
                                        .probe = probe_,
                                        .forces = forcesCard,
                                        .robot = readoutCard,
                                        .readout = readout_,
                                        .drive = drive_,
                                        .events = newsCard});
    connect(layout_, &TerrainLayout::tightened, this, &TerrainPage::tightened);
}

Card* TerrainPage::terrainCard()
{
    auto* card = new Card(tr("Terrain"), this);
    view_ = new QPushButton(tr("view"), card);
    view_->setFocusPolicy(Qt::TabFocus);
    setTip(*view_, tr("Optional marks: draws, a second method"));
    view_->setAccessibleName(tr("View of the terrain"));
    strip_ = new EstimateStrip(card);
    terrain_ = new TerrainProfileView(card);
    tools_ = new PictureTools(*terrain_, [this] { return verdict_->limit(); });
    rear_ = new RearView(rearShapeOf(robot_));
    terrain_->setCorner(rear_);
    connect(terrain_, &TerrainProfileView::shownSidesChanged, this, [this] {
        showOutlines();
        drawContacts();
        showTruth();
    });
    card->note()->hide();
    card->titleRow()->addWidget(strip_, 1);
    card->titleRow()->addWidget(view_);
    card->body()->addWidget(strip_->warnings());
    card->body()->addWidget(terrain_, 1);
    return card;
}

Card* TerrainPage::forceCard()
{
    auto* card = new Card(tr("Front forces"), this);
    forces_ = new ForceBars(card);
    forceLegend_ = new ElidedLabel(card);
    setTone(*forceLegend_, Tone::Muted);
    forceUnit_ = new QPushButton(tr("N / V"), card);
    forceUnit_->setCheckable(true);
    forceUnit_->setFocusPolicy(Qt::TabFocus);
    forceUnit_->setAccessibleName(tr("Raw voltages of the force elements"));
    setTip(*forceUnit_, tr("Raw voltages instead of calibrated forces"));
    connect(forceUnit_, &QPushButton::toggled, this, [this](bool raw) {
        forces_->setUnit(raw ? ForceBars::Unit::Volts : ForceBars::Unit::Newtons);
        showThreshold();
    });
    card->titleRow()->insertWidget(1, forceLegend_);
    card->titleRow()->addWidget(forceUnit_);
    thresholdText_ = card->note();
    card->body()->addWidget(forces_, 1);
    addRearForces(*card);
    return card;
}

/// Adds the bars of the rear flippers. They take the place of the front ones, which keep their size.
void TerrainPage::addRearForces(Card& card)
{
    forcesCard_ = &card;
    rearForces_ = new ForceBars(&card);
    rearForces_->setAccessibleName(tr("Forces on the rear flippers"));
    rearButton_ = new QPushButton(tr("rear"), &card);
    rearButton_->setCheckable(true);
    rearButton_->setFocusPolicy(Qt::TabFocus);
    rearButton_->setAccessibleName(tr("Forces on the rear flippers instead of the front ones"));
    setTip(*rearButton_, rearButton_->accessibleName());
    rearButton_->setVisible(robot_.rearElementShare.has_value());
    connect(rearButton_, &QPushButton::toggled, this, &TerrainPage::showAxle);
    connect(forceUnit_, &QPushButton::toggled, rearForces_, [this](bool raw) {
        rearForces_->setUnit(raw ? ForceBars::Unit::Volts : ForceBars::Unit::Newtons);
    });
    card.titleRow()->addWidget(rearButton_);
    card.body()->addWidget(rearForces_, 1);
    rearForces_->hide();
}

void TerrainPage::showAxle()
{
    const bool rear = rearButton_->isChecked();
    forcesCard_->setTitle(rear ? tr("Rear forces") : tr("Front forces"));
    forces_->setVisible(!rear);
    rearForces_->setVisible(rear);
    forceLegend_->setText((rear ? rearForces_ : forces_)->legend());
}

void TerrainPage::showRearForces(const TerrainViewState& viewState)
{
    if (!robot_.rearElementShare) return;
    const bool known = viewState.measurement && viewState.age <= kStaleAfter && !forcesAge_;
    if (!known) return rearForces_->clearForces();
    if (viewState.count != shownCount_)
        rearForces_->setForces(rearArraysOf(*viewState.measurement), viewState.now);
}

Card* TerrainPage::robotCard()
{
    auto* card = new Card(tr("Robot"), this);
    robotAge_ = card->note();
    robotAge_->setAccessibleName(tr("Age of the telemetry"));
    readout_ = new RobotReadout(card);
    drive_ = new DrivePad(card);
    card->body()->addWidget(readout_, 1);
    card->body()->addWidget(drive_);
    return card;
}

Card* TerrainPage::eventCard()
{
    auto* card = new Card(tr("Last minutes"), this);
    events_ = new EventList(card);
    card->body()->addWidget(events_, 1);
    return card;
}

void TerrainPage::addTerrainTool(QWidget* tool)
{
    terrainCard_->titleRow()->addWidget(tool);
    setTabOrder(view_, tool);
}

void TerrainPage::arrange(Layout layout, int fontScale)
{
    layout_->arrange(layout, fontScale);
    showThreshold();
}

QSize TerrainPage::minimumSizeHint() const
{
    return layout_->tightNeeds().isValid() ? layout_->tightNeeds() : QWidget::minimumSizeHint();
}

void TerrainPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    layout_->fit();
}

void TerrainPage::setThreshold(double newtons)
{
    if (newtons == threshold_) return;
    threshold_ = newtons;
    contacts_.setThreshold(newtons);
    showThreshold();
}

void TerrainPage::showThreshold()
{
    forces_->setThreshold(threshold_);
    rearForces_->setThreshold(threshold_);
    if (forcesAge_) {
        thresholdText_->setText(tr("%1 s old").arg(format::number(*forcesAge_, 1)));
        return setTone(*thresholdText_, Tone::Bad);
    }
    const bool raw = forces_->unit() == ForceBars::Unit::Volts;
    const QString value = format::number(threshold_, 1);
    if (layout_->fontScale() > 100 || forces_->arrays() > 2)  // no room for the word
        thresholdText_->setText(raw ? QString() : tr("- - %1 N").arg(value));
    else
        thresholdText_->setText(raw ? tr("raw voltages") : tr("- - threshold %1 N").arg(value));
    setTone(*thresholdText_, raw ? Tone::Muted : Tone::Bad);
}

}  // namespace terratact
