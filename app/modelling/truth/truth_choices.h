#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "app/modelling/truth/truth_decisions.h"

namespace terratact {

/// Decisions while a person makes them, with undo. Rows count from 0. truth must outlive this object.
class TruthChoices {
public:
    explicit TruthChoices(const LaserTruth& truth) : truth_(truth) {}

    /// Replaces all decisions by those of a file that fits (checkTruthDecisions()); nothing can be undone then.
    void load(const std::vector<TruthDecision>& decisions);

    /// Returns the decision on a row; null: none, which counts as accepted.
    const TruthDecision* decision(std::size_t row) const;
    std::vector<TruthDecision> decisions() const;  ///< by rows
    std::size_t count(TruthDecision::Kind kind) const;

    void accept(std::size_t row);  ///< keeps the nudge
    void
    exclude(std::size_t row);  ///< keeps the nudge, which counts once the row is accepted again
    /// Moves and accepts the scene's heights; clamped to the limits of truth_decisions.h.
    void nudge(std::size_t row, double offset, double tilt, double along);
    void removeNudge(std::size_t row);
    /// Takes the last change back and returns its row; empty: there is none.
    std::optional<std::size_t> undo();
    bool canUndo() const { return !past_.empty(); }

    /// Returns the next row after `from` without a decision whose heights are known, around the end; empty: none.
    std::optional<std::size_t> nextOpen(std::size_t from) const;

private:
    struct Change {
        std::size_t row;
        std::optional<TruthDecision> before;
    };
    TruthDecision current(std::size_t row) const;
    void change(std::size_t row, const TruthDecision& to);

    const LaserTruth& truth_;
    std::map<std::size_t, TruthDecision> chosen_;
    std::vector<Change> past_;
};

}  // namespace terratact
