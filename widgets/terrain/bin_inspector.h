#pragma once

#include <QFrame>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/verdict/bimodality.h"

namespace terratact {

/// One bin up close: its numbers in words, and the histogram of its draws beside the height, upright, so that a
/// heap lies where it does in the profile.
class BinInspector final : public QFrame {
    Q_OBJECT
public:
    static constexpr int kClasses = 24;

    explicit BinInspector(QWidget* parent = nullptr);

    /// words: the bin's numbers, one line each.  Hides itself where there is nothing to show.
    void setBin(const TerrainEstimate& estimate, int bin, const QStringList& words);
    void clear();

    int bin() const { return bin_; }  ///< −1: none
    QStringList lines() const { return words_; }
    /// Draws in each class from `low()` to `high()` [m]; empty without draws.
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
