#include "app/pages/terrain_layout.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "app/shell/console_window.h"
#include "app/shell/font_fit.h"
#include "widgets/base/card.h"
#include "widgets/base/palette.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/drive_strip.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/robot_readout.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

constexpr int kBetween = 10;            // [px] between cards
constexpr int kToSpare = 10;            // [px] spare room below which cards leave
constexpr QSize kMinTerrain{420, 190};  // [px]
// [px] least height where the panel with the forces takes more of the page
constexpr int kDriveTerrainHeight = 240;
constexpr int kColumn = 404, kNarrowColumn = 281;  // [px] width of the decisions, at 100 %
// [px] minimum width of the terrain beside them, at 100 %; it is the largest part
constexpr int kRoomyTerrain = 540, kTightTerrain = 324;
constexpr int kTightTerrainHeight = 230;  // [px]
constexpr double kTerrainToColumn = 1.17;

}  // namespace

TerrainLayout::TerrainLayout(QWidget& page, const Parts& parts)
    : QObject(&page), page_(page), parts_(parts)
{
    decisions_ = new QWidget(&page_);
    auto* reserved = new QHBoxLayout(decisions_);
    reserved->setContentsMargins(0, 0, 0, 0);
    reserved->setSpacing(0);
    question_ = new QSpacerItem(0, 0);
    decide_ = new QVBoxLayout;
    reserved->addLayout(decide_);
    reserved->addItem(question_);
    decide_->setSpacing(kBetween);
    decide_->addWidget(parts_.atem);
    decide_->addWidget(parts_.probe, 1);
    column_ = new QVBoxLayout;
    column_->setSpacing(kBetween);
    column_->addWidget(decisions_, 1);
    upper_ = new QHBoxLayout;
    upper_->setSpacing(kBetween);
    ground_ = new QVBoxLayout;
    ground_->setSpacing(kBetween);
    ground_->addWidget(parts_.verdict);
    ground_->addWidget(parts_.driving);
    ground_->addWidget(parts_.terrainCard, 1);
    upper_->addLayout(ground_, 1);
    upper_->addLayout(column_);
    lowerPanel_ = new QWidget(&page_);
    lower_ = new QHBoxLayout(lowerPanel_);
    lower_->setContentsMargins(0, 0, 0, 0);
    lower_->setSpacing(kBetween);
    recent_ = new QHBoxLayout;
    recent_->setSpacing(kBetween);
    recent_->addWidget(parts_.robot);
    recent_->addWidget(parts_.events);
    lower_->addWidget(parts_.forces);
    lower_->addLayout(recent_);

    rows_ = new QVBoxLayout(&page_);
    rows_->setSpacing(kBetween);
    rows_->addLayout(upper_);
    rows_->addWidget(lowerPanel_);
}

void TerrainLayout::placeLower()
{
    if (rows_->indexOf(lowerPanel_) < 0) rows_->addWidget(lowerPanel_);
    share();
}

void TerrainLayout::stackLower(bool stacked)
{
    stacked_ = stacked;
    share();
}

void TerrainLayout::placeDecisions()
{
    if (column_->indexOf(decisions_) < 0) column_->insertWidget(1, decisions_, 1);
}

void TerrainLayout::setVerdictBeside(int columnWidth)
{
    columnWidth_ = columnWidth;
    if (!verdictBeside_) column_->addStretch();  // if only the verdict is beside the terrain
    verdictBeside_ = true;
    arrange(layout_, fontScale_);
}

void TerrainLayout::allowTight(const ConsoleWindow& window)
{
    window_ = &window;
    arrange(layout_, fontScale_);
}

void TerrainLayout::arrange(Layout layout, int fontScale)
{
    const bool isMeasured = roomyNeeds_.isValid() && layout == layout_ && fontScale == fontScale_;
    layout_ = layout;
    fontScale_ = fontScale;
    if (isMeasured) return;
    if (window_) {
        const bool tight = tight_;
        measures_ = true;
        tightNeeds_ = needs(true);
        roomyNeeds_ = needs(false);
        setTight(tight);
        measures_ = false;
        fit();
    } else {
        setTight(false);
    }
}

/// Returns the size [px] that the page needs in this arrangement.
QSize TerrainLayout::needs(bool tight)
{
    forgetSizes(*decisions_);  // setTight() reserves their height in this font
    setTight(tight);
    forgetSizes(page_);
    forgetSizes(*lowerPanel_);  // the panel may be elsewhere
    const QMargins margins = rows_->contentsMargins();
    QSize size = upper_->minimumSize();
    if (!tight) {
        // Reserves a banner's line, because fitTightness() adds the height that banners take.
        const int line = window_->bannerLine();
        size.setHeight(
            std::max(size.height() + line,
                     column_->minimumSize().height() + parts_.probe->givenHeight() + kToSpare));
    }
    const auto below = [&size](const QSize& part) {
        size = {std::max(size.width(), part.width()), size.height() + kBetween + part.height()};
    };
    for (const QWidget* strip :
         std::initializer_list<const QWidget*>{parts_.verdict, parts_.driving})
        if (rows_->indexOf(strip) >= 0) below(strip->minimumSizeHint());
    if (!tight) below(lowerPanel_->minimumSizeHint());
    return size.grownBy(margins);
}

void TerrainLayout::measure()
{
    roomyNeeds_ = {};
    arrange(layout_, fontScale_);
}

void TerrainLayout::fit()
{
    fitTightness();
    setColumn();
    // The title's row may keep the width that it had with another column.
    if (!measures_) forgetSizes(*parts_.terrainCard);
}

void TerrainLayout::fitTightness()
{
    if (!window_ || measures_) return;
    const QSize room = page_.size() + QSize(0, window_->bannersHeight());  // size without a banner
    const bool tight = room != room.expandedTo(roomyNeeds_);
    if (tight == tight_ && (rows_->indexOf(lowerPanel_) < 0) == tight) return;
    setTight(tight);
    emit tightened(tight);
    rows_->activate();
}

void TerrainLayout::setTight(bool tight)
{
    tight_ = tight;
    if (window_) stacked_ = tight;
    const int margin = tight ? 4 : kBetween;
    rows_->setContentsMargins(12, margin, 12, margin);
    for (QBoxLayout* const layout : {rows_, ground_, decide_}) layout->setSpacing(margin);
    parts_.atem->setNarrow(tight);
    parts_.probe->setNarrow(tight);
    parts_.drive->setNarrow(tight);
    // A banner takes its line from the terrain and the proposal, so that it never makes the cards leave.
    if (window_) parts_.terrain->setMinimumSize(leastTerrain(tight));
    if (window_) parts_.terrainCard->setMinimumWidth(scaled(tight ? kTightTerrain : kRoomyTerrain));
    // The attitude is shown once on a page: where the robot's card is on this one, by the drive strip.
    parts_.readout->showAttitude(tight || verdictBeside_);
    // Driving stays on the page; the rest of its card moves.
    if (tight)
        decide_->addWidget(parts_.drive);
    else
        parts_.robot->body()->addWidget(parts_.drive);
    setColumn();
    placeVerdict();
    share();
}

/// Returns the least size [px] of the terrain's picture.
QSize TerrainLayout::leastTerrain(bool tight) const
{
    if (tight) return {0, kTightTerrainHeight};
    const int height = layout_ == Layout::Drive ? kDriveTerrainHeight : kMinTerrain.height();
    return {kMinTerrain.width(), height - window_->bannerLine()};
}

/// In the tight arrangement the decisions are narrow enough that the terrain is wider.
void TerrainLayout::setColumn()
{
    int wide = scaled(tight_ ? kNarrowColumn : kColumn);
    if (tight_ && window_ && !measures_) {
        const int room = page_.width() - rows_->contentsMargins().left()
                       - rows_->contentsMargins().right() - kBetween;
        const auto share = static_cast<int>(room / (1.0 + kTerrainToColumn));
        wide = std::clamp(share, wide, scaled(kColumn));
    }
    for (QWidget* card : std::initializer_list<QWidget*>{parts_.atem, parts_.probe})
        card->setFixedWidth(wide);
    // Reserves the proposal's height, so that nothing moves when it appears.
    question_->changeSize(0, verdictBeside_ ? 0
                                            : parts_.atem->leastHeight() + decide_->spacing()
                                                  + parts_.probe->leastHeight());
}

void TerrainLayout::placeVerdict()
{
    // A large font leaves no room for the result beside the card's title. A review's page already has its name.
    QBoxLayout *beside = parts_.terrainCard->titleRow(), *below = parts_.terrainCard->body();
    const bool large = fontScale_ > 100 || tight_, apart = fontScale_ > 100 && !verdictBeside_;
    for (QBoxLayout* row : {beside, below}) row->removeWidget(parts_.strip);
    (apart ? below : beside)->insertWidget(apart ? 1 : 2, parts_.strip, apart ? 0 : 1);
    beside->setStretch(0, apart ? 1 : 0);
    beside->itemAt(0)->widget()->setVisible(!large || apart);
    // A large font leaves no room for the verdict above the terrain, so it stands above the whole page.
    for (QBoxLayout* column : {ground_, rows_, column_})
        for (QWidget* strip : std::initializer_list<QWidget*>{parts_.verdict, parts_.driving})
            column->removeWidget(strip);
    (large && !verdictBeside_ ? rows_ : ground_)->insertWidget(0, parts_.driving);
    (verdictBeside_ ? column_ : large ? rows_ : ground_)->insertWidget(0, parts_.verdict);
    parts_.verdict->setStacked(verdictBeside_);
    if (verdictBeside_) parts_.verdict->setFixedWidth(scaled(columnWidth_));
}

void TerrainLayout::share()
{
    struct Shares {
        int upper, lower, forces, robot, events;
    };
    const Shares shares = verdictBeside_            ? Shares{17, 6, 9, 8, 16}
                        : layout_ == Layout::Drive  ? Shares{13, 9, 10, 11, 0}
                        : layout_ == Layout::Review ? Shares{13, 9, 9, 8, 16}
                                                    : Shares{17, 6, 10, 9, 10};
    rows_->setStretchFactor(upper_, shares.upper + (fontScale_ > 100 ? 4 : 0));
    rows_->setStretchFactor(lowerPanel_, shares.lower);
    lower_->setStretch(0, shares.forces);
    lower_->setStretch(1, shares.robot + shares.events);
    recent_->setDirection(stacked_ ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    recent_->setStretch(0, stacked_ ? 0 : shares.robot);
    recent_->setStretch(1, stacked_ ? 1 : shares.events);
    recent_->itemAt(1)->widget()->setVisible(shares.events > 0);
    // With a large font the preconditions of exploring are shown completely before driving gets large buttons.
    parts_.drive->setProminent(layout_ == Layout::Drive && !(tight_ && fontScale_ > 120));
    showDrive();
}

void TerrainLayout::setProposes(bool proposes)
{
    proposes_ = proposes;
    showDrive();
}

/// A narrow column has no room for driving beside a proposal; the robot stands still meanwhile.
void TerrainLayout::showDrive()
{
    parts_.drive->setVisible(layout_ != Layout::Review && !(tight_ && proposes_));
}

}  // namespace terratact
