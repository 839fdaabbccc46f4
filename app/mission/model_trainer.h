#pragma once

#include <QObject>
#include <QString>
#include <QThread>
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

#include "app/modelling/training/model_comparison.h"
#include "app/modelling/training/model_training.h"

namespace terratact {

/// Share of the machine that training may use beside the live console.
struct TrainingLoad {
    int threads = 1;  ///< maximum
    /// Nice value of the training threads: 0, like the console, … 19, lowest priority.
    int nice = 19;
};

/// Returns all processors but one (at least one), at the lowest priority.
TrainingLoad politeLoad();

/// Progress of a training or comparison.
struct TrainingProgress {
    enum class State : std::uint8_t { Waiting, Running, Done, Skipped };
    struct Cell {
        State state = State::Waiting;
        std::optional<double> logLikelihood;
        bool operator==(const Cell&) const = default;
    };
    /// State of the newest training.
    std::array<std::array<Cell, kTrainingKinds.size()>, kBins> cells{};
    double share = 0.0;    ///< 0 … 1 of the running work
    double seconds = 0.0;  ///< since its start
    bool operator==(const TrainingProgress&) const = default;

    /// Returns the remaining time [s] at the present pace; empty if the pace is unknown.
    std::optional<double> secondsLeft() const;
};

/// Trains and compares models in its own thread. Start a job only after the last one has ended. Every job ends in
/// exactly one of its signals. GUI thread only; signals arrive there.
class ModelTrainer final : public QObject {
    Q_OBJECT
public:
    explicit ModelTrainer(TrainingLoad load = politeLoad(), QObject* parent = nullptr);
    ~ModelTrainer() override;  ///< cancels a running job and waits for it

    bool busy() const { return busy_; }

    /// Trains a model and writes it to `path`, creating its directory if needed. The file appears only when complete
    /// and never replaces another. The trainer's load overrides the plan's.
    void train(TrainingPlan plan, const QString& path);
    /// Compares two models; the trainer's load overrides the plan's.
    void compare(ComparisonPlan plan);
    void cancel();  ///< ends in `cancelled` soon

    /// Clients poll it; there is no signal.
    TrainingProgress progress() const;

signals:
    void noticed(const QString& text);  ///< a notice about the training file
    void trained(const QString& path, int scenes);
    void compared(const terratact::ModelComparison& comparison);
    void failed(const QString& why);
    void cancelled();

private:
    void begin(std::function<void()> work);
    void doTrain(const TrainingPlan& plan, const QString& path);
    void doCompare(const ComparisonPlan& plan);
    void end(std::function<void()> report);

    TrainingLoad load_;
    QThread thread_;
    QObject there_;  ///< lives in thread_
    bool busy_ = false;
    std::atomic<bool> cancelled_ = false;
    mutable std::mutex mutex_;  ///< guards the two members below
    TrainingProgress progress_;
    double began_ = 0.0;             ///< [s] steady clock
    mutable TrainingProgress seen_;  ///< last value of progress()
};

}  // namespace terratact
