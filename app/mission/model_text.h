#pragma once

#include <QCoreApplication>
#include <QString>

#include "app/modelling/model_cards.h"

namespace terratact {

/// A model as an operator reads it.
class ModelWords {
    Q_DECLARE_TR_FUNCTIONS(ModelWords)
public:
    /// When, on what ground and on how much it was trained, its hash, and how it did: a few lines.
    static QString card(const ModelFacts& facts);
};

}  // namespace terratact
