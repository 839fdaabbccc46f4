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

void setLabel(QwtPlotTextLabel& label, QwtText words)
{
    words.setRenderFlags(Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap);
    QColor behind = theme().card;
    behind.setAlpha(0xe0);
    words.setBackgroundBrush(behind);
    label.setText(words);
    label.setVisible(!words.text().isEmpty());
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
    constexpr int kMax = 8;    // the legend takes at most 1/8 of the height
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

namespace {

Qt::BrushStyle patternOf(Touch touch)
{
    switch (touch) {
    case Touch::Bounded: return Qt::HorPattern;
    case Touch::Remembered: return Qt::Dense7Pattern;
    default: return Qt::BDiagPattern;
    }
}

/// Line of a zone's word, counted from the top: words of neighbouring zones do not cover each other.
int lineOf(Touch touch)
{
    if (touch == Touch::Remembered) return 3;  // below the word of the horizon
    return touch == Touch::Bounded ? 1 : 0;
}

}  // namespace

BinZones::BinZones() : QwtPlotItem(QwtText("prior only"))
{
    setZ(1.0);
    setItemAttribute(QwtPlotItem::Legend, false);
}

bool BinZones::isShown() const
{
    const auto any = [](const Unfelt& side) {
        return std::ranges::find(side.shown, true) != side.shown.end();
    };
    return any(full) || (light && any(*light));
}

BinZones::Kind BinZones::kindOf(std::size_t bin) const
{
    const auto touchOf = [bin](const Unfelt& side) {
        return side.shown[bin] ? std::optional(side.touch[bin]) : std::nullopt;
    };
    return {touchOf(full), light ? touchOf(*light) : std::nullopt};
}

void BinZones::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& /*y*/,
                    const QRectF& canvas) const
{
    for (const Zone& zone : zonesOn(x, canvas)) drawZone(*painter, zone);
    drawHorizons(*painter, x, canvas);
}

std::vector<BinZones::Zone> BinZones::zonesOn(const QwtScaleMap& x, const QRectF& canvas) const
{
    std::vector<Zone> zones;
    for (std::size_t i = 0; i < kBins; ++i) {
        const Kind kind = kindOf(i);
        if (!kind || (i > 0 && kindOf(i - 1) == kind)) continue;
        std::size_t last = i;
        while (last + 1 < kBins && kindOf(last + 1) == kind) ++last;
        const double from = std::round(x.transform(binBegin(static_cast<int>(i))));
        const double to = std::round(x.transform(binEnd(static_cast<int>(last))));
        zones.push_back({kind, {from, canvas.top(), to - from, canvas.height()}});
    }
    return zones;
}

void BinZones::drawWords(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
                         const QRectF& canvas) const
{
    imu_ = {QPointF(x.transform(0.0) - scaled(40), y.transform(0.0) - scaled(10)),
            QPointF(x.transform(0.0) + scaled(8), y.transform(0.0) + scaled(10))};
    arm_ = arm ? armTipArea(*arm, x, y, canvas) : QRectF();
    words_.clear();
    painter.setFont(sized(plot()->font(), 13));
    painter.setPen(theme().warning);
    for (const Zone& zone : zonesOn(x, canvas)) drawWord(painter, zone, canvas);
    const Unfelt& side = nearest();
    if (!side.horizon) return;
    const bool isOfBoth = !light || light->horizon == full.horizon;
    drawHorizonWord(painter, side, isOfBoth ? QString() : side.letter + QLatin1Char(' '),
                    std::round(x.transform(*side.horizon)) + 0.5, canvas);
}

/// Returns the word of a zone. Where both sides are not felt, but differ, it is that of the side in full. A bin that is
/// only bounded, of the lighter side alone, has lines but no word.
QString BinZones::wordOf(const Kind& kind) const
{
    const auto word = [](Touch touch) {
        return touch == Touch::Unrecorded ? TerrainProfileView::tr("prior only") : touchWord(touch);
    };
    if (!light || kind.full == kind.light) return word(*kind.full);
    if (kind.full) return full.letter + QLatin1Char(' ') + word(*kind.full);
    return kind.light == Touch::Bounded ? QString()
                                        : light->letter + QLatin1Char(' ') + word(*kind.light);
}

void BinZones::drawZone(QPainter& painter, const Zone& zone) const
{
    const Kind& kind = zone.kind;
    const bool isWhole = !light || (kind.full && kind.light);
    QColor fill = theme().priorZone;
    fill.setAlpha(isWhole ? 0xc0 : 0x70);
    if (kind.shown() != Touch::Remembered) painter.fillRect(zone.place, fill);
    QColor hatch = theme().warning;
    hatch.setAlpha(isWhole ? 0x60 : 0x30);
    painter.fillRect(zone.place, QBrush(hatch, patternOf(kind.shown())));
}

void BinZones::drawWord(QPainter& painter, const Zone& zone, const QRectF& canvas) const
{
    const QString label = wordOf(zone.kind);
    if (label.isEmpty()) return;
    const double width = painter.fontMetrics().horizontalAdvance(label);
    QRectF place(zone.place.center().x() - width / 2.0 - 2.0,
                 zone.place.top() + 5.0 + lineOf(zone.kind.shown()) * scaled(20), width + 4.0,
                 scaled(20));
    place.moveLeft(std::min(place.left(), canvas.right() - place.width()));
    place = free(place, canvas);
    painter.fillRect(place, theme().priorZone);
    painter.drawText(place, Qt::AlignCenter, label);
    words_.push_back(place);
}

/// Returns the place, or the first one below it that no other word has.
QRectF BinZones::free(QRectF place, const QRectF& canvas) const
{
    const auto isTaken = [&] {
        return imu_.intersects(place) || arm_.intersects(place)
            || std::ranges::any_of(words_,
                                   [&](const QRectF& word) { return word.intersects(place); });
    };
    const QRectF first = place;
    while (isTaken()) {
        place.translate(0.0, place.height());
        if (place.bottom() > canvas.bottom()) return first;
    }
    return place;
}

/// Of two sides the nearer horizon has words and a thicker line, because CLEAR reaches to it at most.
const BinZones::Unfelt& BinZones::nearest() const
{
    if (!light || !light->horizon) return full;
    return full.horizon && *full.horizon <= *light->horizon ? full : *light;
}

void BinZones::drawHorizons(QPainter& painter, const QwtScaleMap& x, const QRectF& canvas) const
{
    const auto line = [&](const std::optional<double>& horizon, double width) {
        if (!horizon) return;
        const double px = std::round(x.transform(*horizon)) + 0.5;
        painter.setPen(QPen(theme().warning, width, Qt::DashLine));
        painter.drawLine(QPointF(px, canvas.top()), QPointF(px, canvas.bottom()));
    };
    const Unfelt& near = nearest();
    if (light) line((&near == &full ? *light : full).horizon, 1.0);
    line(near.horizon, 2.0);
}

void BinZones::drawHorizonWord(QPainter& painter, const Unfelt& side, const QString& letter,
                               double px, const QRectF& canvas) const
{
    const QString label =
        letter + TerrainProfileView::tr("felt to %1").arg(format::signedLength(*side.horizon, 2));
    const double width = painter.fontMetrics().horizontalAdvance(label) + 6.0;
    QRectF place(px - width - 3.0, canvas.top() + 5.0 + 2.0 * scaled(20), width, scaled(20));
    place = free(place, canvas);
    painter.fillRect(place, theme().priorZone);
    painter.drawText(place, Qt::AlignCenter, label);
    words_.push_back(place);
}

ZoneWords::ZoneWords(const BinZones& zones) : zones_(zones)
{
    constexpr double kAboveRobot = 6.0;
    setZ(kAboveRobot);
    setItemAttribute(QwtPlotItem::Legend, false);
}

void ZoneWords::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                     const QRectF& canvas) const
{
    zones_.drawWords(*painter, x, y, canvas);
}

QRectF armTipArea(const QPointF& at, const QwtScaleMap& x, const QwtScaleMap& y,
                  const QRectF& canvas)
{
    const double px = std::round(x.transform(at.x())) + 0.5, half = scaled(7);
    const double least =
        canvas.top() + scaled(28 + 20 + 24);  // puts label and tip below the zones' words
    const double tip = std::max(y.transform(at.y()) - scaled(8), least);
    return {px - half, tip - scaled(16), 2.0 * half, static_cast<double>(scaled(16))};
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
    tip_ = armTipArea({at, down}, x, y, canvas);
    const double px = tip_.center().x(), tip = tip_.bottom();
    const double highest = canvas.top() + scaled(28);
    const double top =
        state == ArmTip::State::Touched ? std::max(tip - scaled(64), highest) : highest;
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
    const double half = 0.5 * tip_.width();
    painter->setPen(QPen(theme().accent, 2.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter->setBrush(open ? theme().card : theme().accent);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->drawPolygon(QPolygonF({tip_.topLeft(),
                                    tip_.topRight(),
                                    {px + half, tip - scaled(8)},
                                    {px, tip},
                                    {px - half, tip - scaled(8)}}));
}

/// Returns the place of the arm's word: above the line, else beside a zone's word, else a row lower.
QRectF ArmMark::placeOfWord(const QRectF& above, double px, double tip, const QRectF& canvas) const
{
    constexpr int kRows = 6;  // rows of words; the zones use three, or more for two sides
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

/// Returns the y at which the line begins, below every word above the tip that it would cross.
double ArmMark::beginOfLine(double px, double top) const
{
    double begin = top;
    const auto below = [&](const QRectF& word) {
        const bool isCrossed = word.left() < px && word.right() > px && word.top() < tip_.top();
        if (isCrossed) begin = std::max(begin, word.bottom() + 1.0);
    };
    for (const QRectF& word : zones_.words()) below(word);
    below(word_);
    return begin;
}

QString ArmMark::words() const
{
    const QString before = letter.isEmpty() ? QString() : letter + QLatin1Char(' ');
    switch (state) {
    case ArmTip::State::Proposed: return before + TerrainProfileView::tr("arm tip: probe?");
    case ArmTip::State::Probing: return before + TerrainProfileView::tr("arm tip: probing");
    case ArmTip::State::Touched: return before + TerrainProfileView::tr("arm tip");
    }
    return {};
}

}  // namespace terratact
