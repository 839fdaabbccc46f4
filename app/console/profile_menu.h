#pragma once

#include <QMenu>

namespace terratact {

class Exploration;
class TerrainProfileView;

/// Menu of the terrain's layers: draws, second method.
class ProfileMenu final : public QMenu {
    Q_OBJECT
public:
    ProfileMenu(TerrainProfileView& view, Exploration& exploration, QWidget* parent = nullptr);

    QAction& draws() const { return *draws_; }  ///< toggles the draws

private:
    void offerSecondMethods(Exploration& exploration);

    QAction* draws_;
};

}  // namespace terratact
