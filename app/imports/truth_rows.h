#pragma once

#include <QAbstractTableModel>

#include "app/modelling/truth/truth_choices.h"

namespace terratact {

/// Returns why a scene has no heights, in the operator's language; empty: it has.
QString gapText(TruthGap gap);
/// Returns a nudge: "+5 mm, +0.3°, +20 mm along"; empty: none.
QString nudgeText(const TruthDecision* decision);
/// Returns a decision: "accepted", "excluded" or "open".
QString decisionText(const TruthDecision* decision);

/// The scenes of a truth file as a table model, a row for each.
class TruthRows final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Number, Decision, Cloud, Nudge, Known, Drive, Time, kColumns };
    /// Both must outlive this object.
    TruthRows(const LaserTruth& truth, const TruthChoices& choices, QObject* parent);

    void refresh(std::size_t row);  ///< after a decision
    void refreshAll();
    static int known(const SceneTruth& scene, bool isPlane);  ///< bins with heights

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    QString text(std::size_t row, int column) const;

    const LaserTruth& truth_;
    const TruthChoices& choices_;
};

}  // namespace terratact
