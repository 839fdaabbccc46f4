#pragma once

#include <QCoreApplication>
#include <QList>
#include <QString>

#include "app/modelling/model_comparison.h"

namespace terratact {

/// A comparison of two models as an operator reads it.
class ComparisonWords {
    Q_DECLARE_TR_FUNCTIONS(ComparisonWords)
public:
    struct Row {
        QString what, before, after, difference;
    };
    static QList<Row> rows(const ModelComparison& comparison);

    /// "The new model errs 12 % less near the robot on 300 scenes …"
    static QString sentence(const ModelComparison& comparison);

    /// What makes it less than it seems; empty where nothing does.
    static QString caution(const ModelComparison& comparison);
};

}  // namespace terratact
