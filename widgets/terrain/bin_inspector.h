#pragma once

#include <QFrame>
#include <array>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/verdict/bimodality.h"

namespace terratact {

/// One bin in detail: its numbers as text, and an upright histogram of its draws beside the heights. A mode of the
/// draws has the same orientation as in the profile.
class BinInspector final : public QFrame {
    Q_OBJECT
public:
    static constexpr int kClasses = 24;

    explicit BinInspector(QWidget* parent = nullptr);

    /// words: the bin's numbers, one per line. The inspector hides itself if there is nothing to show.
    void setBin(const TerrainEstimate& estimate, int bin, const QStringList& words);
    /// Shows both sides; their histograms stand back to back, the left side at the left.
    void setBin(const TerrainEstimate& left, const TerrainEstimate& right, int bin,
                const QStringList& words);
    void clear();

    int bin() const { return bin_; }  ///< −1: no bin
    QStringList lines() const { return words_; }
    /// Returns the draws per class between `low()` and `high()` [m]; empty without draws. Of two sides: the left one.
    const std::vector<int>& histogram() const { return shown_[0].counts; }
    /// Returns the same of the right side; empty if one side or one plane is shown.
    const std::vector<int>& rightHistogram() const { return shown_[1].counts; }
    double low() const { return low_; }
    double high() const { return high_; }

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Numbers of one estimate [m].
    struct Shown {
        std::vector<int> counts;
        double q10 = 0.0, q90 = 0.0, height = 0.0;
    };
    void setEstimates(const std::vector<const TerrainEstimate*>& estimates, int bin,
                      const QStringList& words);
    void drawHistogram(QPainter& painter, const Shown& shown, const QRectF& place,
                       bool leftwards) const;

    int bin_ = -1;
    QStringList words_;
    std::array<Shown, 2> shown_;
    bool isBoth_ = false;            ///< left and right side
    double low_ = 0.0, high_ = 0.0;  ///< [m] range of all histograms
};

}  // namespace terratact
