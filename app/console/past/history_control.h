#pragma once

#include <QObject>
#include <cstdint>

#include "app/display/event_severity.h"
#include "core/base/message.h"

namespace terratact {

class ConsoleWindow;
class EstimateHistory;
class Exploration;
class HistoryWindow;
struct Measurement;
struct PastEstimate;
struct TerrainViewState;

/// Lets the operator look back at estimates of this run. It changes the terrain's picture alone: verdict, proposals,
/// commands and feel forward are those of the present. The picture returns to the present with a new estimate or
/// preview, at an exploration, and when the robot drives. GUI thread only.
class HistoryControl final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive the object.
    HistoryControl(Exploration& exploration, ConsoleWindow& window);
    ~HistoryControl() override;

    void open();         ///< opens the window of the list, made at first use
    void showPresent();  ///< takes everything of the past out of the picture
    bool showsPast() const { return shown_ != 0; }
    /// Returns the text of a banner while the picture shows anything of the past; empty: it does not.
    QString banner() const;
    /// Puts what the operator has chosen into the picture. Call for every frame of the window.
    void apply(TerrainViewState& viewState);

    const EstimateHistory& history() const { return *history_; }
    HistoryWindow* window() const { return list_; }  ///< null: it was never opened

signals:
    void happened(const terratact::Message& text, terratact::EventSeverity severity);

private:
    void show(std::int64_t number);
    void lay(std::int64_t number);
    void showWaySince(const PastEstimate& past, const Measurement* now);
    bool isOvertaken(const TerrainViewState& viewState) const;

    Exploration& exploration_;
    ConsoleWindow& console_;
    EstimateHistory* history_;
    HistoryWindow* list_ = nullptr;
    std::int64_t shown_ = 0;      ///< number of the estimate in the picture; 0: the present
    std::int64_t laid_ = 0;       ///< number of the estimate laid over the present; 0: none
    QString drivenSince_;         ///< part of the banner: since the estimate that is laid
    std::uint64_t standing_ = 0;  ///< revision of the present estimate when it was chosen
};

}  // namespace terratact
