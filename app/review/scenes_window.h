#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/mission/estimator_worker.h"
#include "app/runtime/revised.h"
#include "app/shell/console_window.h"
#include "core/base/message.h"
#include "core/learn/data/two_track_scene.h"
#include "core/robot/robot_model.h"

class QLabel;

namespace terratact {

class SceneRows;
class ScenesPage;
class TerrainPage;
struct SceneResult;

/// Shows the scenes of a file one by one, each with its estimate. The true terrain is shown if the file has it, with
/// the error. A list shows verdict and error of every scene; scenes that are not shown are estimated one by one
/// meanwhile. It has no source, so it cannot command a robot.
class ScenesWindow final : public ConsoleWindow {
    Q_OBJECT
public:
    struct Options {
        QString path;
        std::vector<TwoTrackScene> scenes;  ///< at least one scene; one plane has equal sides
        RobotModel robot;
        ModelLoader model;
        Settings settings{};
        double stepLimit = kStepLimit;  ///< [m]
    };
    explicit ScenesWindow(Options options);
    ~ScenesWindow() override;

    void showScene(std::size_t scene);  ///< clamped to the last scene
    std::size_t scene() const { return scene_; }
    const std::optional<TwoTrackEstimate>& estimate() const { return estimate_.value(); }
    TerrainPage* terrainPage() const { return page_; }
    ScenesPage* list() const { return list_; }
    QLabel* stateLabel() const { return state_; }

private:
    void defineKeys();
    void go(int by);
    void ask();
    void estimateNext();
    void estimated(const TwoTrackEstimate& estimate, double seconds);
    void failed(const Message& why);
    void setResult(SceneResult result);
    void showViewState();
    QString errorText() const;

    Options options_;
    Measurement measurement_;
    std::optional<Heights> truth_;
    std::optional<std::array<Heights, 2>> sideTruth_;
    std::unique_ptr<EstimatorWorker> worker_;
    std::size_t scene_ = 0;
    std::size_t jobScene_ = 0;  ///< scene of the running job
    std::uint64_t shows_ = 0;
    int job_ = 0;
    double seconds_ = 0.0;
    Message trouble_;
    Revised<TwoTrackEstimate> estimate_;

    QLabel* state_ = nullptr;
    TerrainPage* page_ = nullptr;
    SceneRows* rows_ = nullptr;
    ScenesPage* list_ = nullptr;
};

}  // namespace terratact
