#pragma once

#include <functional>
#include <optional>

#include "app/shell/page.h"
#include "core/infer/estimate/estimate.h"
#include "core/infer/verdict/obstacle.h"
#include "core/infer/verdict/verdict.h"

class QLabel;
class QPushButton;

namespace terratact {

class KeyTable;
class NumbersTable;

/// What the numbers are of.
struct NumbersViewState {
    const TerrainEstimate* estimate = nullptr;  ///< null: there is none
    QString whyNoEstimate{};
    double stepLimit = kStepLimit;     ///< [m]
    std::optional<Verdict> verdict{};  ///< of the estimate
    std::optional<double> age{};       ///< [s] of the newest telemetry; empty: not known
};

/// The estimate as a table that can be read aloud and copied.
class NumbersPage final : public Page {
    Q_OBJECT
public:
    /// look: at what is to be shown.
    explicit NumbersPage(std::function<NumbersViewState()> look, QWidget* parent = nullptr);
    void refresh(double now) override;
    /// Ctrl+C copies the table while the page is seen, wherever the focus is.
    void addKeys(KeyTable& keys);

    NumbersTable* table() const { return table_; }
    QPushButton* copyButton() const { return copy_; }

private:
    std::function<NumbersViewState()> look_;
    QLabel* verdict_ = nullptr;
    QLabel* summary_ = nullptr;
    NumbersTable* table_ = nullptr;
    QPushButton* copy_ = nullptr;
    void showVerdict(const NumbersViewState& viewState);

    std::optional<TerrainEstimate> shown_;
    double shownLimit_ = 0.0;
};

}  // namespace terratact
