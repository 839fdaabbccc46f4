#include <qwt_plot_textlabel.h>
#include <qwt_scale_map.h>
#include <qwt_text.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QStringList>
#include <algorithm>

#include "app/display/format.h"
#include "core/infer/verdict/verdict.h"
#include "widgets/base/drawable.h"
#include "widgets/terrain/bin_inspector.h"
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
            : tr("no part of the robot above it"),
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
    if (!staleOverlay_->words.isEmpty()) lines.prepend(tr("not live: no telemetry from the robot"));
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
