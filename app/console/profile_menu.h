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

signals:
    void historyWanted();  ///< the operator chose the list of estimates

private:
    void offerSecondMethods(Exploration& exploration);

    QAction* draws_;
    QAction* restore_;
};

}  // namespace terratact
