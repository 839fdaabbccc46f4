#pragma once

#include "app/page.h"
#include "core/infer/estimate.h"

class QLabel;
class QPushButton;

namespace terratact {

class Exploration;
class NumbersTable;

/// The estimate as a table that can be read aloud and copied.
class NumbersPage final : public Page {
    Q_OBJECT
public:
    explicit NumbersPage(const Exploration& exploration, QWidget* parent = nullptr);
    void refresh(double now) override;

    NumbersTable* table() const { return table_; }
    QPushButton* copyButton() const { return copy_; }

private:
    const Exploration& exploration_;
    QLabel* summary_ = nullptr;
    NumbersTable* table_ = nullptr;
    QPushButton* copy_ = nullptr;
    std::optional<TerrainEstimate> shown_;
    double shownLimit_ = 0.0;
};

}  // namespace terratact
