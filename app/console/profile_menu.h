#pragma once

#include <QMenu>

namespace terratact {

class Exploration;
class TerrainProfileView;

/// What else is drawn in the terrain: draws, a second method.
class ProfileMenu final : public QMenu {
    Q_OBJECT
public:
    ProfileMenu(TerrainProfileView& view, Exploration& exploration, QWidget* parent = nullptr);

    QAction& draws() const { return *draws_; }  ///< shows them

private:
    void offerSecondMethods(Exploration& exploration);

    QAction* draws_;
};

}  // namespace terratact
