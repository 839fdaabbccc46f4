#include <qwt_plot_textlabel.h>
#include <qwt_scale_map.h>
#include <qwt_text.h>

#include <QKeyEvent>
#include <QStringList>
#include <algorithm>

#include "app/display/format.h"
#include "app/display/place_text.h"
#include "core/infer/verdict/bimodality.h"
#include "core/infer/verdict/verdict.h"
#include "widgets/base/drawable.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/earlier_layer.h"
#include "widgets/terrain/profile_layers.h"
#include "widgets/terrain/provenance_text.h"
#include "widgets/terrain/terrain_items.h"
#include "widgets/terrain/terrain_profile_view.h"
#include "widgets/terrain/touch_text.h"

// One bin in detail, by mouse, by keys and as text for a screen reader.

namespace terratact {

void TerrainProfileView::inspect(std::optional<int> bin)
{
    if (!estimate_ || !bin) return inspector_->clear();
    if (light())
        inspector_->setBin(of(Side::Left), of(Side::Right), *bin, closeUp(*bin));
    else
        inspector_->setBin(*full(), *bin, closeUp(*bin));
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

namespace {

QString ceilingText(double ceiling)
{
    return ceiling < kDrawableLimit
             ? TerrainProfileView::tr("ceiling %1").arg(format::signedLength(ceiling, 3))
             : TerrainProfileView::tr("no part of the robot above it");
}

QString bandText(const TerrainEstimate& e, std::size_t i)
{
    return TerrainProfileView::tr("80 % in %1 … %2")
        .arg(format::signedLengthNumber(e.q10[i], 3), format::signedLength(e.q90[i], 3));
}

QStringList modeTexts(const TwoModes& two)
{
    return {
        TerrainProfileView::tr("either %1 (%2 %)")
            .arg(format::signedLength(two.lowMean, 2), format::number(100.0 * two.lowShare, 0)),
        TerrainProfileView::tr("or %1 (%2 %)")
            .arg(format::signedLength(two.highMean, 2), format::number(100.0 * two.highShare, 0))};
}

}  // namespace

QStringList TerrainProfileView::closeUp(int bin) const
{
    const QString title = tr("bin %1").arg(format::binName(bin));
    if (light()) return QStringList{title} + briefly(bin, Side::Left) + briefly(bin, Side::Right);
    const TerrainEstimate& e = *full();
    const auto i = static_cast<std::size_t>(bin);
    const auto side = sideInFull();
    QStringList lines{
        side ? title + QStringLiteral(" · ") + sideWord(*side) : title,
        tr("height %1 ± %2").arg(format::signedLength(e.height[i], 3), format::length(e.sd[i], 3)),
        bandText(e, i),
        ceilingText(e.ceiling[i]),
        tr("from: %1 (%2)")
            .arg(provenanceWord(provenance(e, bin)), provenanceLetter(provenance(e, bin))),
        tr("touch: %1").arg(touchWord(e.touch[i]))};
    if (const auto& two = twoHeights_->modes[i]) lines << modeTexts(*two);
    return lines;
}

/// Returns the lines of one side where both are shown.
QStringList TerrainProfileView::briefly(int bin, Side side) const
{
    const TerrainEstimate& e = of(side);
    const auto i = static_cast<std::size_t>(bin);
    QStringList lines{
        tr("%1: height %2 ± %3")
            .arg(sideWord(side), format::signedLength(e.height[i], 3), format::length(e.sd[i], 3)),
        bandText(e, i), ceilingText(e.ceiling[i]),
        provenanceWord(provenance(e, bin)) + QStringLiteral(" · ") + touchWord(e.touch[i])};
    if (const auto two = twoModes(e)[i]) lines << modeTexts(*two).join(QLatin1Char(' '));
    return lines;
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
    return estimate_ && bin >= 0 && bin < kBins ? binTextOf(*full(), bin) : QString();
}

QString TerrainProfileView::binTextOf(const TerrainEstimate& e, int bin) const
{
    const auto i = static_cast<std::size_t>(bin);
    const Touch touch = e.touch[i];
    const bool recorded = touch != Touch::Unrecorded;
    if (recorded && isUnfeltAhead(e, bin))
        return tr("bin %1: %2").arg(format::binName(bin), touchWord(touch));
    const QString known =
        tr("bin %1: %2, 80 % in %3 … %4, %5")
            .arg(format::binName(bin), format::signedLength(e.height[i], 2),
                 format::signedLengthNumber(e.q10[i], 2), format::signedLengthNumber(e.q90[i], 2),
                 provenanceWord(provenance(e, bin)));
    return recorded ? known + QStringLiteral(", ") + touchWord(touch) : known;
}

void TerrainProfileView::describe()
{
    QStringList lines;
    const auto describeSide = [&](Side side, bool named) {
        for (int bin = 0; bin < kBins; ++bin)
            lines << (named ? sideWord(side) + QStringLiteral(", ") : QString())
                         + binTextOf(of(side), bin);
    };
    if (const auto side = sideInFull(); light()) {
        for (const Side each : {Side::Left, Side::Right}) describeSide(each, true);
    } else if (estimate_) {
        describeSide(side.value_or(Side::Left), side.has_value());
    }
    if (const QString note = note_->text().text(); !note.isEmpty()) lines.prepend(note);
    lines = measuredLines() + lines;
    if (!staleOverlay_->words.isEmpty()) lines.prepend(tr("not live: no telemetry from the robot"));
    if (const QString note = rememberedNote_->text().text(); !note.isEmpty()) lines << note;
    if (const auto count = earlier_->count(); count > 0)
        lines << tr("earlier sections of ground behind it: %1").arg(count);
    setAccessibleDescription(lines.join(QLatin1Char('\n')));
}

bool TerrainProfileView::eventFilter(QObject* object, QEvent* event)
{
    if (object == canvas() && navigate(*event)) return true;
    if (object == canvas() && event->type() == QEvent::Leave) inspect(std::nullopt);
    return QwtPlot::eventFilter(object, event);
}

void TerrainProfileView::keyPressEvent(QKeyEvent* event)
{
    if (navigateByKey(*event) || measureByKey(*event)) return;
    const int now = inspector_->bin();
    if (event->key() == Qt::Key_Right) return inspect(now < 0 ? 0 : std::min(now + 1, kBins - 1));
    const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enters && now >= 0) return void(emit binChosen({now, sideToProbe()}));
    if (event->key() == Qt::Key_Left) return inspect(now < 0 ? kBins - 1 : std::max(now - 1, 0));
    QwtPlot::keyPressEvent(event);
}

void TerrainProfileView::focusOutEvent(QFocusEvent* event)
{
    inspect(std::nullopt);
    QwtPlot::focusOutEvent(event);
}

}  // namespace terratact
