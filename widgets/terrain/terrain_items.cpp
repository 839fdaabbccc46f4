#include "widgets/terrain/terrain_items.h"

#include <qwt_graphic.h>
#include <qwt_plot.h>
#include <qwt_scale_map.h>
#include <qwt_text.h>

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/display/format.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/touch_text.h"

namespace terratact {

QFont sized(QFont font, int pixels, bool bold)
{
    font.setPixelSize(scaled(pixels));
    font.setBold(bold);
    return font;
}

QwtText inked(const QString& words, const QColor& colour, const QFont& font)
{
    QwtText result(words);
    result.setColor(colour);
    result.setFont(font);
    return result;
}

QwtGraphic LineItem::legendIcon(int /*index*/, const QSizeF& /*size*/) const
{
    QwtGraphic icon;
    icon.setDefaultSize(QSizeF(20, 14));
    QPainter painter(&icon);
    painter.setPen(pen());
    painter.drawLine(QPointF(0, 7), QPointF(20, 7));
    return icon;
}

bool Key::isEmpty() const
{
    constexpr int kLow = 160;  // [px] at 100 %
    constexpr int kMax = 6;    // the legend takes at most 1/6 of the height
    return view_.height() < scaled(kLow) || heightForWidth(view_.width()) * kMax > view_.height()
        || QwtLegend::isEmpty();
}

QRectF Note::textRect(const QRectF& plot, const QSizeF& oneLine) const
{
    const double width = std::min(oneLine.width(), plot.width());
    return {plot.center().x() - width / 2.0, plot.top(), width,
            text().heightForWidth(width, text().font())};
}

BandKey::BandKey() : QwtPlotItem(QwtText(TerrainProfileView::tr("80 % band")))
{
    setItemAttribute(QwtPlotItem::Legend);
}

void BandKey::draw(QPainter* /*painter*/, const QwtScaleMap& /*x*/, const QwtScaleMap& /*y*/,
                   const QRectF& /*canvas*/) const
{
}

QwtGraphic BandKey::legendIcon(int /*index*/, const QSizeF& /*size*/) const
{
    QwtGraphic icon;
    icon.setDefaultSize(QSizeF(16, 16));
    QPainter painter(&icon);
    painter.setPen(QPen(theme().sampled, 3.0));
    painter.drawLine(QPointF(1, 8), QPointF(15, 8));
    painter.setPen(QPen(theme().sampled, 2.0));
    painter.drawLine(QPointF(8, 1), QPointF(8, 15));
    painter.drawLine(QPointF(3, 1), QPointF(13, 1));
    painter.drawLine(QPointF(3, 15), QPointF(13, 15));
    return icon;
}

BinBorders::BinBorders()
{
    setZ(0.6);
    setItemAttribute(QwtPlotItem::Legend, false);
}

void BinBorders::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& /*y*/,
                      const QRectF& canvas) const
{
    painter->setPen(theme().grid);
    for (int bin = 0; bin <= kBins; ++bin) {
        const double px = std::round(x.transform(binBegin(bin))) + 0.5;
        painter->drawLine(QPointF(px, canvas.top()), QPointF(px, canvas.bottom()));
    }
}

BinZones::BinZones() : QwtPlotItem(QwtText("prior only"))
{
    setZ(1.0);
    setItemAttribute(QwtPlotItem::Legend, false);
}

bool BinZones::isShown() const
{
    return std::ranges::find(shown, true) != shown.end();
}

void BinZones::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& /*y*/,
                    const QRectF& canvas) const
{
    words_.clear();
    for (std::size_t i = 0; i < kBins; ++i) {
        const auto goesOn = [&](std::size_t k) { return shown[k] && touch[k] == touch[i]; };
        if (!shown[i] || (i > 0 && goesOn(i - 1))) continue;
        std::size_t last = i;
        while (last + 1 < kBins && goesOn(last + 1)) ++last;
        const double from = std::round(x.transform(binBegin(static_cast<int>(i))));
        const double to = std::round(x.transform(binEnd(static_cast<int>(last))));
        drawZone(*painter, touch[i], {from, canvas.top(), to - from, canvas.height()}, canvas);
    }
    if (horizon) drawHorizon(*painter, std::round(x.transform(*horizon)) + 0.5, canvas);
}

void BinZones::drawZone(QPainter& painter, Touch kind, const QRectF& zone,
                        const QRectF& canvas) const
{
    QColor fill = theme().priorZone;
    fill.setAlpha(0xc0);
    painter.fillRect(zone, fill);
    QColor hatch = theme().doubt;
    hatch.setAlpha(0x60);
    painter.fillRect(zone,
                     QBrush(hatch, kind == Touch::Bounded ? Qt::HorPattern : Qt::BDiagPattern));
    painter.setPen(theme().doubt);
    painter.setFont(sized(plot()->font(), 13));
    const bool bounded = kind == Touch::Bounded;  // its word is one line below the others
    const QString label =
        kind == Touch::Unrecorded ? TerrainProfileView::tr("prior only") : touchWord(kind);
    const double width = painter.fontMetrics().horizontalAdvance(label);
    QRectF place(zone.center().x() - width / 2.0 - 2.0,
                 zone.top() + 5.0 + (bounded ? scaled(20) : 0.0), width + 4.0, scaled(20));
    place.moveLeft(std::min(place.left(), canvas.right() - place.width()));
    painter.fillRect(place, theme().priorZone);
    painter.drawText(place, Qt::AlignCenter, label);
    words_.push_back(place);
}

void BinZones::drawHorizon(QPainter& painter, double px, const QRectF& canvas) const
{
    painter.setPen(QPen(theme().doubt, 2.0, Qt::DashLine));
    painter.drawLine(QPointF(px, canvas.top()), QPointF(px, canvas.bottom()));
    painter.setFont(sized(plot()->font(), 13));
    const QString label =
        TerrainProfileView::tr("felt to %1 m").arg(format::signedNumber(*horizon, 2));
    const double width = painter.fontMetrics().horizontalAdvance(label) + 6.0;
    const QRectF place(px - width - 3.0, canvas.top() + 5.0 + 2.0 * scaled(20), width, scaled(20));
    painter.fillRect(place, theme().priorZone);
    painter.setPen(theme().doubt);
    painter.drawText(place, Qt::AlignCenter, label);
    words_.push_back(place);
}

ArmMark::ArmMark(const BinZones& zones) : QwtPlotItem(QwtText("arm")), zones_(zones)
{
    setZ(28.0);
    setItemAttribute(QwtPlotItem::Legend, false);
}

void ArmMark::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                   const QRectF& canvas) const
{
    const bool open = state == ArmTip::State::Proposed;
    const double px = std::round(x.transform(at)) + 0.5;
    const double least =
        canvas.top() + scaled(28 + 20 + 24);  // puts label and tip below the zones' words
    const double tip = std::max(y.transform(down) - scaled(8), least);
    const double top = state == ArmTip::State::Touched
                         ? std::max(tip - scaled(64), least - scaled(44))
                         : canvas.top() + scaled(28);
    painter->setFont(sized(plot()->font(), 14, true));
    painter->setPen(theme().accent);
    const double width = painter->fontMetrics().horizontalAdvance(words()) + 4.0;
    word_ = placeOfWord({px - width / 2.0, top, width, static_cast<double>(scaled(20))}, px, tip,
                        canvas);
    painter->drawText(word_, Qt::AlignCenter, words());
    QPen pen(theme().accent, open ? 2.0 : scaled(5), open ? Qt::CustomDashLine : Qt::SolidLine,
             Qt::FlatCap);
    if (open) pen.setDashPattern({4.0, 3.0});
    painter->setPen(pen);
    painter->drawLine(QPointF(px, beginOfLine(px, top)), QPointF(px, tip - scaled(14)));
    const double half = scaled(7);
    painter->setPen(QPen(theme().accent, 2.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter->setBrush(open ? theme().card : theme().accent);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->drawPolygon(QPolygonF({{px - half, tip - scaled(16)},
                                    {px + half, tip - scaled(16)},
                                    {px + half, tip - scaled(8)},
                                    {px, tip},
                                    {px - half, tip - scaled(8)}}));
}

/// Returns the place of the arm's word: above the line, else beside a zone's word, else a row lower.
QRectF ArmMark::placeOfWord(const QRectF& above, double px, double tip, const QRectF& canvas) const
{
    constexpr int kRows = 4;  // rows of words; the zones use three
    const double beside = scaled(12);
    const auto isFree = [&](const QRectF& place) {
        return place.left() >= canvas.left() && place.right() <= canvas.right()
            && std::ranges::none_of(zones_.words(),
                                    [&](const QRectF& word) { return word.intersects(place); });
    };
    QRectF first = above;
    first.moveLeft(std::max(canvas.left(), std::min(above.left(), canvas.right() - above.width())));
    for (int row = 0; row < kRows; ++row)
        for (const double left : {first.left(), px + beside, px - beside - above.width()}) {
            const QRectF place(left, above.top() + row * above.height(), above.width(),
                               above.height());
            const bool isUponLine = place.left() < px && place.right() > px;
            if (isFree(place) && !(isUponLine && row > 0 && place.bottom() > tip - scaled(24)))
                return place;
        }
    return first;
}

/// Returns the y at which the line begins, below every word it would cross.
double ArmMark::beginOfLine(double px, double top) const
{
    double begin = top;
    const auto below = [&](const QRectF& word) {
        if (word.left() < px && word.right() > px) begin = std::max(begin, word.bottom() + 1.0);
    };
    for (const QRectF& word : zones_.words()) below(word);
    below(word_);
    return begin;
}

QString ArmMark::words() const
{
    switch (state) {
    case ArmTip::State::Proposed: return TerrainProfileView::tr("arm tip: probe?");
    case ArmTip::State::Probing: return TerrainProfileView::tr("arm tip: probing");
    case ArmTip::State::Touched: return TerrainProfileView::tr("arm tip");
    }
    return {};
}

}  // namespace terratact
