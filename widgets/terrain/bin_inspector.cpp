#include "widgets/terrain/bin_inspector.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/display/format.h"
#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"

namespace terratact {
namespace {

constexpr int kMargin = 10, kPlotWidth = 96, kMinPlotHeight = 120;

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
    if (bin < 0 || bin >= kBins) return clear();
    const auto i = static_cast<std::size_t>(bin);
    bin_ = bin;
    words_ = words;
    height_ = estimate.height[i];
    q10_ = estimate.q10[i];
    q90_ = estimate.q90[i];
    std::vector<double> heights;
    for (const Heights& draw : estimate.draws)
        if (drawable(draw[i])) heights.push_back(draw[i]);
    counts_.clear();
    if (!heights.empty()) {
        const auto [least, greatest] = std::minmax_element(heights.begin(), heights.end());
        const double middle = 0.5 * (*least + *greatest);
        const double half = std::max(
            0.01, 0.5 * (*greatest - *least));  // minimum range for a bin with constant draws
        low_ = middle - half;
        high_ = middle + half;
        counts_.assign(kClasses, 0);
        for (const double h : heights) {
            const auto at = static_cast<int>((h - low_) / (high_ - low_) * kClasses);
            ++counts_[static_cast<std::size_t>(std::clamp(at, 0, kClasses - 1))];
        }
    }
    setAccessibleDescription(words_.join(QLatin1Char('\n')));
    resize(sizeHint());
    show();
    update();
}

void BinInspector::clear()
{
    bin_ = -1;
    words_.clear();
    counts_.clear();
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
    if (counts_.empty()) return;
    const QRectF plot(width() - kMargin - kPlotWidth, kMargin, kPlotWidth, height() - 2 * kMargin);
    const auto at = [&](double metres) {
        return plot.bottom() - (metres - low_) / (high_ - low_) * plot.height();
    };
    const int most = *std::max_element(counts_.begin(), counts_.end());
    const double each = plot.height() / kClasses;
    painter.setPen(Qt::NoPen);
    for (int k = 0; k < kClasses; ++k) {
        const double middle = low_ + (k + 0.5) / kClasses * (high_ - low_);
        QColor fill = theme().sampled;
        if (middle < q10_ || middle > q90_) fill.setAlpha(0x70);  // outside the 80 % band
        const double length = plot.width() * counts_[static_cast<std::size_t>(k)] / most;
        painter.fillRect(QRectF(plot.left(), plot.bottom() - (k + 1) * each, length, each - 1.0),
                         fill);
    }
    painter.setPen(QPen(theme().text, 1.5, Qt::DashLine));
    if (drawable(height_))
        painter.drawLine(QPointF(plot.left(), at(height_)), QPointF(plot.right(), at(height_)));
}

}  // namespace terratact
