#pragma once

#include <QCoreApplication>
#include <QList>
#include <QString>

#include "app/modelling/training/model_comparison.h"

namespace terratact {

/// Texts of a comparison of two models.
class ComparisonWords {
    Q_DECLARE_TR_FUNCTIONS(ComparisonWords)
public:
    struct Row {
        QString what, before, after, difference;
    };
    static QList<Row> rows(const ModelComparison& comparison);

    /// Returns "Near the robot the new model's mean error is 12 % smaller on 300 scenes …".
    static QString sentence(const ModelComparison& comparison);

    /// Returns what weakens the result; empty: nothing.
    static QString caution(const ModelComparison& comparison);
};

}  // namespace terratact
