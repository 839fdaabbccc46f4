#pragma once

#include <functional>
#include <optional>

#include "app/shell/page.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/infer/verdict/obstacle.h"
#include "core/infer/verdict/two_track_verdict.h"

class QLabel;
class QPushButton;

namespace terratact {

class KeyTable;
class NumbersTable;

/// Content of the numbers page.
struct NumbersViewState {
    const TwoTrackEstimate* estimate = nullptr;  ///< null: no estimate
    std::uint64_t revision = 0;                  ///< equal revisions mean the same estimate
    QString whyNoEstimate{};
    double stepLimit = kStepLimit;             ///< [m]
    std::optional<TwoTrackVerdict> verdict{};  ///< verdict of the estimate
    std::optional<double> age{};               ///< [s] age of the newest telemetry; empty: unknown
};

/// The estimate as a table for screen readers and the clipboard.
class NumbersPage final : public Page {
    Q_OBJECT
public:
    /// read: returns the content to show.
    explicit NumbersPage(std::function<NumbersViewState()> read, QWidget* parent = nullptr);
    void refresh(double now) override;
    /// Adds Ctrl+C, which copies the table while the page is visible, whichever widget has the focus.
    void addKeys(KeyTable& keys);

    NumbersTable* table() const { return table_; }
    QPushButton* copyButton() const { return copy_; }

private:
    std::function<NumbersViewState()> read_;
    QLabel* verdict_ = nullptr;
    QLabel* summary_ = nullptr;
    NumbersTable* table_ = nullptr;
    QPushButton* copy_ = nullptr;
    void showVerdict(const NumbersViewState& viewState);

    std::optional<std::uint64_t> shown_;  ///< revision; empty: none
    double shownLimit_ = 0.0;
};

}  // namespace terratact
