#include <qwt_plot_textlabel.h>
#include <qwt_text.h>

#include <QTimer>
#include <algorithm>
#include <limits>

#include "app/display/format.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/earlier_layer.h"
#include "widgets/terrain/remembered_layer.h"
#include "widgets/terrain/terrain_items.h"
#include "widgets/terrain/terrain_profile_view.h"

// Remembered ground.

namespace terratact {
namespace {

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

/// Returns the rear end of the strip [m]; that of the robot's picture, if the strip is shorter.
double rearOf(const SeenStrip& strip)
{
    double rear = ProfileAxes::kLeft;
    for (const auto& side : strip.side)
        if (!side.empty()) rear = std::min(rear, side.front().x);
    return rear;
}

}  // namespace

void TerrainProfileView::setRemembered(const SeenStrip& strip, const QString& why)
{
    if (strip == remembered_->strip() && why == whyNothingRemembered_) return;
    whyNothingRemembered_ = why;
    remembered_->setStrip(strip, estimate_.has_value());
    earlier_->setRear(rearOf(strip));
    if (isZoomed()) setWindow(axes_.zoom(), axes_.shift(), axes_.rise());
    showRemembered();
    showMeasurement();
    describe();
    fitAxes();
    replot();
}

void TerrainProfileView::setEarlier(const std::vector<EarlierSection>& sections)
{
    if (sections == earlier_->sections()) return;
    earlier_->setSections(sections);
    if (isZoomed()) setWindow(axes_.zoom(), axes_.shift(), axes_.rise());
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
    const QString sd = format::length(numbers.sd, 2);
    if (const QString title = tr("remembered ± %1").arg(sd);
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
        note = tr("remembered ground · %1 driven since · heights ± %2")
                   .arg(format::length(numbers.way, 2), sd);
    setLabel(*rememberedNote_,
             inked(note, isShown ? theme().sampled : theme().muted, sized(font(), 15, true)));
    arrangeNotes();
}

}  // namespace terratact
