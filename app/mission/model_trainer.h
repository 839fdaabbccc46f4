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

#include "app/modelling/model_comparison.h"
#include "app/modelling/model_training.h"

namespace terratact {

/// How much of the machine training may take beside the live console.
struct TrainingLoad {
    int threads = 1;  ///< at most
    int nice =
        19;  ///< nice value of the threads that train: 0, as the rest of the console, … 19, last in the queue
};

/// All processors but one, of a machine with one that one, and last in the queue.
TrainingLoad politeLoad();

/// How far a training or a comparison is.
struct TrainingProgress {
    enum class State : std::uint8_t { Waiting, Running, Done, Skipped };
    struct Cell {
        State state = State::Waiting;
        std::optional<double> logLikelihood;
        bool operator==(const Cell&) const = default;
    };
    std::array<std::array<Cell, kTrainingKinds.size()>, kBins> cells{};  ///< of the newest training
    double share = 0.0;    ///< 0 … 1 of the work under way
    double seconds = 0.0;  ///< since it began
    bool operator==(const TrainingProgress&) const = default;

    /// [s] at the pace so far; empty while there is none to judge by.
    std::optional<double> secondsLeft() const;
};

/// Trains models and compares them, in a thread of its own.  One thing at a time: start nothing before the last
/// one has ended.  Every start ends in exactly one of its signals.  GUI thread only, where the signals arrive.
class ModelTrainer final : public QObject {
    Q_OBJECT
public:
    explicit ModelTrainer(TrainingLoad load = politeLoad(), QObject* parent = nullptr);
    ~ModelTrainer() override;  ///< cancels what runs and waits for it

    bool busy() const { return busy_; }

    /// Trains a model and puts it at `path`, whose directory is made where it is missing.  The file is there only
    /// when it is whole; one that was there is not replaced.  The load is the trainer's, not the plan's.
    void train(TrainingPlan plan, const QString& path);
    /// Likewise for the load.
    void compare(ComparisonPlan plan);
    void cancel();  ///< ends in `cancelled`, soon

    /// To be looked at, not to be signalled.
    TrainingProgress progress() const;

signals:
    void noticed(const QString& text);  ///< something about the training's file
    void trained(const QString& path, int scenes);
    void compared(const terratact::ModelComparison& comparison);
    void failed(const QString& why);
    void cancelled();

private:
    void begin(std::function<void()> work);
    void doTrain(const TrainingPlan& plan, const QString& path);
    void doCompare(const ComparisonPlan& plan);
    void end(std::function<void()> tell);

    TrainingLoad load_;
    QThread thread_;
    QObject there_;  ///< lives in thread_
    bool busy_ = false;
    std::atomic<bool> cancelled_ = false;
    mutable std::mutex mutex_;  ///< guards the two below
    TrainingProgress progress_;
    double began_ = 0.0;             ///< [s] steady clock
    mutable TrainingProgress seen_;  ///< as progress() last told it
};

}  // namespace terratact
