#include "widgets/terrain/bin_inspector.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/display/place_text.h"
#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"

namespace terratact {
namespace {

constexpr int kMargin = 10, kPlotWidth = 96, kMinPlotHeight = 120;

/// Returns the number of heights in each class between low and high; empty without heights.
std::vector<int> classesOf(const std::vector<double>& heights, double low, double high)
{
    if (heights.empty()) return {};
    std::vector<int> counts(BinInspector::kClasses, 0);
    for (const double h : heights) {
        const auto at = static_cast<int>((h - low) / (high - low) * BinInspector::kClasses);
        ++counts[static_cast<std::size_t>(std::clamp(at, 0, BinInspector::kClasses - 1))];
    }
    return counts;
}

}  // namespace

BinInspector::BinInspector(QWidget* parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("binInspector"));
    setAccessibleName(tr("Selected bin"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void BinInspector::setBin(const TerrainEstimate& estimate, int bin, const QStringList& words)
{
    setEstimates({&estimate}, bin, words);
}

void BinInspector::setBin(const TerrainEstimate& left, const TerrainEstimate& right, int bin,
                          const QStringList& words)
{
    setEstimates({&left, &right}, bin, words);
}

void BinInspector::setEstimates(const std::vector<const TerrainEstimate*>& estimates, int bin,
                                const QStringList& words)
{
    if (bin < 0 || bin >= kBins) return clear();
    const auto i = static_cast<std::size_t>(bin);
    bin_ = bin;
    words_ = words;
    isBoth_ = estimates.size() > 1;
    std::array<std::vector<double>, 2> heights;
    std::vector<double> all;
    for (std::size_t side = 0; side < estimates.size(); ++side) {
        const TerrainEstimate& e = *estimates[side];
        shown_[side] = {.counts = {}, .q10 = e.q10[i], .q90 = e.q90[i], .height = e.height[i]};
        for (const Heights& draw : e.draws)
            if (drawable(draw[i])) heights[side].push_back(draw[i]);
        all.insert(all.end(), heights[side].begin(), heights[side].end());
    }
    if (!isBoth_) shown_[1] = {};
    if (!all.empty()) {
        const auto [least, greatest] = std::minmax_element(all.begin(), all.end());
        const double middle = 0.5 * (*least + *greatest);
        const double half = std::max(
            0.01, 0.5 * (*greatest - *least));  // minimum range for a bin with constant draws
        low_ = middle - half;
        high_ = middle + half;
    }
    for (std::size_t side = 0; side < estimates.size(); ++side)
        shown_[side].counts = classesOf(heights[side], low_, high_);
    setAccessibleDescription(words_.join(QLatin1Char('\n')));
    resize(sizeHint());
    show();
    update();
}

void BinInspector::clear()
{
    bin_ = -1;
    words_.clear();
    shown_ = {};
    hide();
}

QSize BinInspector::sizeHint() const
{
    const QFontMetrics metrics(font());
    int width = 0;
    for (const QString& line : words_) width = std::max(width, metrics.horizontalAdvance(line));
    const int text = static_cast<int>(words_.size()) * metrics.lineSpacing();
    return {width + kPlotWidth + 3 * kMargin, std::max(text, kMinPlotHeight) + 2 * kMargin};
}

void BinInspector::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme().muted, 1.0));
    painter.setBrush(theme().card);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);

    const QFontMetrics metrics(font());
    QFont bold = font();
    bold.setBold(true);
    int y = kMargin + metrics.ascent();
    painter.setPen(theme().text);
    for (const QString& line : words_) {
        painter.setFont(&line == &words_.front() ? bold : font());
        painter.drawText(kMargin, y, line);
        y += metrics.lineSpacing();
    }
    const QRectF plot(width() - kMargin - kPlotWidth, kMargin, kPlotWidth, height() - 2 * kMargin);
    if (!isBoth_) return drawHistogram(painter, shown_[0], plot, false);
    const double half = plot.width() / 2.0 - 1.0, letters = metrics.height();
    const QRectF left(plot.left(), plot.top(), half, plot.height() - letters);
    const QRectF right(plot.right() - half, plot.top(), half, plot.height() - letters);
    drawHistogram(painter, shown_[0], left, true);
    drawHistogram(painter, shown_[1], right, false);
    painter.setFont(bold);
    painter.setPen(theme().text);
    painter.drawText(QRectF(left.left(), left.bottom(), half, letters), Qt::AlignCenter,
                     sideLetter(Side::Left));
    painter.drawText(QRectF(right.left(), right.bottom(), half, letters), Qt::AlignCenter,
                     sideLetter(Side::Right));
    painter.setPen(QPen(theme().muted, 1.0));
    painter.drawLine(QPointF(plot.center().x(), left.top()),
                     QPointF(plot.center().x(), left.bottom()));
}

void BinInspector::drawHistogram(QPainter& painter, const Shown& shown, const QRectF& place,
                                 bool leftwards) const
{
    if (shown.counts.empty()) return;
    const auto at = [&](double metres) {
        return place.bottom() - (metres - low_) / (high_ - low_) * place.height();
    };
    const int most = std::max(1, *std::max_element(shown.counts.begin(), shown.counts.end()));
    const double each = place.height() / kClasses;
    for (int k = 0; k < kClasses; ++k) {
        const double middle = low_ + (k + 0.5) / kClasses * (high_ - low_);
        QColor fill = theme().sampled;
        if (middle < shown.q10 || middle > shown.q90) fill.setAlpha(0x70);  // outside the 80 % band
        const double length = place.width() * shown.counts[static_cast<std::size_t>(k)] / most;
        painter.fillRect(QRectF(leftwards ? place.right() - length : place.left(),
                                place.bottom() - (k + 1) * each, length, each - 1.0),
                         fill);
    }
    painter.setPen(QPen(theme().text, 1.5, Qt::DashLine));
    if (drawable(shown.height))
        painter.drawLine(QPointF(place.left(), at(shown.height)),
                         QPointF(place.right(), at(shown.height)));
}

}  // namespace terratact
