#pragma once

#include <QWidget>
#include <vector>

#include "app/modelling/truth/truth_slice.h"
#include "core/terrain/outline.h"

namespace terratact {

/// Draws a scene from the side: the slice of the cloud, the robot, and bins with ± one and two sd. The left side has
/// dots and solid lines, the right one crosses and dashed lines. An excluded scene is crossed out.
class TruthView final : public QWidget {
    Q_OBJECT
public:
    struct Scene {
        Outline outline;
        std::vector<SlicePoint> slice;
        std::array<SideTruth, 2> side{};  ///< left, right; of one plane the left one
        bool isPlane = false;
        bool isExcluded = false;
        QString gap;  ///< why there are no heights; empty: there are
    };
    enum class Sides { Both, Left, Right };

    explicit TruthView(QWidget* parent = nullptr);

    void setScene(Scene scene);
    const Scene& scene() const { return scene_; }
    void setSides(Sides sides);
    Sides sides() const { return sides_; }

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool shows(Side side) const;

    Scene scene_;
    Sides sides_ = Sides::Both;
};

}  // namespace terratact
