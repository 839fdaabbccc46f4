#pragma once

#include <QFrame>
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
    void clear();

    int bin() const { return bin_; }  ///< −1: no bin
    QStringList lines() const { return words_; }
    /// Returns the draws per class between `low()` and `high()` [m]; empty without draws.
    const std::vector<int>& histogram() const { return counts_; }
    double low() const { return low_; }
    double high() const { return high_; }

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int bin_ = -1;
    QStringList words_;
    std::vector<int> counts_;
    double low_ = 0.0, high_ = 0.0;  // [m]
    double q10_ = 0.0, q90_ = 0.0, height_ = 0.0;
};

}  // namespace terratact
