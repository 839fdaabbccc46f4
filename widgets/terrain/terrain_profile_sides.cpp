#include <qwt_plot_shapeitem.h>

#include "app/display/place_text.h"
#include "core/infer/verdict/verdict.h"
#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/provenance_marks.h"
#include "widgets/terrain/side_items.h"
#include "widgets/terrain/terrain_items.h"
#include "widgets/terrain/terrain_profile_view.h"

// Left and right of a two-track estimate.

namespace terratact {
namespace {

Side otherSide(Side side)
{
    return side == Side::Left ? Side::Right : Side::Left;
}

/// Returns the two ends of a side's line [m].
SideTags::Tag tagOf(const TerrainEstimate& estimate, Side side, double aside, bool isFull)
{
    return {.side = side,
            .rear = {binCentre(0) + aside, estimate.height.front()},
            .front = {binCentre(kBins - 1) + aside, estimate.height.back()},
            .isFull = isFull};
}

bool isRemembered(const TerrainEstimate& estimate, int bin)
{
    return estimate.touch[static_cast<std::size_t>(bin)] == Touch::Remembered;
}

BinZones::Unfelt unfeltOf(const TerrainEstimate& estimate, const QString& letter)
{
    BinZones::Unfelt unfelt{.touch = estimate.touch, .horizon = feltHorizon(estimate)};
    for (int bin = 0; bin < kBins; ++bin)
        unfelt.shown[static_cast<std::size_t>(bin)] =
            isUnfeltAhead(estimate, bin) || isRemembered(estimate, bin);
    unfelt.letter = letter;
    return unfelt;
}

MarkLetters::Row lettersOf(const TerrainEstimate& estimate)
{
    MarkLetters::Row row{};
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        if (drawable(estimate.height[i])) row[i] = provenance(estimate, bin);
    }
    return row;
}

}  // namespace

std::optional<Side> TerrainProfileView::sideInFull() const
{
    if (!estimate_ || estimate_->onePlane) return std::nullopt;
    switch (shownSides_) {
    case ShownSides::Both: return fullSide_;
    case ShownSides::Left: return Side::Left;
    case ShownSides::Right: return Side::Right;
    }
    return std::nullopt;
}

ProbeSide TerrainProfileView::sideToProbe() const
{
    const auto side = sideInFull();
    if (!side) return ProbeSide::Middle;
    return *side == Side::Left ? ProbeSide::Left : ProbeSide::Right;
}

std::optional<ProbePlace> TerrainProfileView::selectedPlace() const
{
    if (inspector_->bin() < 0) return std::nullopt;
    return ProbePlace{inspector_->bin(), sideToProbe()};
}

const TerrainEstimate* TerrainProfileView::full() const
{
    return estimate_ ? &of(sideInFull().value_or(Side::Left)) : nullptr;
}

const TerrainEstimate* TerrainProfileView::light() const
{
    const auto side = sideInFull();
    return side && shownSides_ == ShownSides::Both ? &of(otherSide(*side)) : nullptr;
}

void TerrainProfileView::setShownSides(ShownSides sides)
{
    if (sides == shownSides_) return;
    shownSides_ = sides;
    showEstimate();
    emit shownSidesChanged();
}

void TerrainProfileView::setFullSide(Side side)
{
    if (side == fullSide_) return;
    fullSide_ = side;
    if (shownSides_ == ShownSides::Both && sideInFull()) showEstimate();
}

void TerrainProfileView::addSides()
{
    lightSide_ = new LightSide;
    lightSide_->attach(this);
    sideTags_ = new SideTags;
    sideTags_->attach(this);
    for (const Side side : {Side::Left, Side::Right}) {
        sideKeys_[indexOf(side)] = new SideKey(side);
        sideKeys_[indexOf(side)]->attach(this);
    }
}

/// Makes the line of the side in full hollow for the left side and solid otherwise.
void TerrainProfileView::styleSides()
{
    const bool isHollow = sideInFull() == Side::Left;
    for (QwtPlotShapeItem* core : {meanCore_, meanPriorCore_}) core->setVisible(isHollow);
    mean_->setPen(sideLinePen(theme().sampled, isHollow ? kHollowLine : kSideLine));
    QPen soft(theme().sampled, 2.5, Qt::CustomDashLine, Qt::RoundCap, Qt::RoundJoin);
    soft.setDashPattern({2.5, 2.5});
    meanPrior_->setPen(isHollow ? sidePriorPen(theme().sampled, kHollowLine) : soft);
    meanCore_->setPen(sideLinePen(theme().card, kHollowCore));
    meanPriorCore_->setPen(sidePriorPen(theme().card, kHollowCore));
}

/// Sets what depends on which sides are shown: the lighter side, zones, letters and tags.
void TerrainProfileView::showSides()
{
    const auto side = sideInFull();
    const TerrainEstimate *const whole = full(), *const lighter = light();
    const QString letter = side ? sideLetter(*side) : QString();
    const QString lightLetter = side ? sideLetter(otherSide(*side)) : QString();
    zones_->full = whole ? unfeltOf(*whole, letter) : BinZones::Unfelt{};
    zones_->light = lighter ? std::optional(unfeltOf(*lighter, lightLetter)) : std::nullopt;
    letters_->shown = whole ? lettersOf(*whole) : MarkLetters::Row{};
    letters_->letter = letter;
    letters_->light = lighter ? std::optional(lettersOf(*lighter)) : std::nullopt;
    letters_->lightLetter = lightLetter;
    letters_->isLightAbove = side == Side::Right;
    lightSide_->estimate = lighter ? std::optional(*lighter) : std::nullopt;
    sideTags_->tags.clear();
    if (side) {
        lightSide_->side = otherSide(*side);
        sideTags_->tags.push_back(tagOf(*whole, *side, 0.0, true));
    }
    if (lighter)
        sideTags_->tags.push_back(tagOf(*lighter, lightSide_->side, lightSide_->aside(), false));
    for (SideKey* key : sideKeys_)
        if (key->testItemAttribute(QwtPlotItem::Legend) != side.has_value())
            key->setItemAttribute(QwtPlotItem::Legend, side.has_value());
    styleSides();
}

void TerrainProfileView::showSecond()
{
    const auto side = sideInFull().value_or(Side::Left);
    second_->estimate =
        secondEstimate_ ? std::optional(secondEstimate_->side[indexOf(side)]) : std::nullopt;
}

}  // namespace terratact
