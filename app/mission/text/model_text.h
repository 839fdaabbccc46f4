#pragma once

#include <QCoreApplication>
#include <QString>

#include "app/modelling/evaluation/model_cards.h"

namespace terratact {

/// Texts about a model.
class ModelWords {
    Q_DECLARE_TR_FUNCTIONS(ModelWords)
public:
    /// Returns date, ground and amount of training, the hash, and the scores, in a few lines.
    static QString card(const ModelFacts& facts);
};

}  // namespace terratact
