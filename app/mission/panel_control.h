#pragma once

#include <memory>
#include <optional>

#include "app/link/panel_reader.h"
#include "app/mission/exploration.h"
#include "core/base/message.h"

namespace terratact {

/// Maps the panel's buttons to the window's actions and drives its lamps. GUI thread only.
class PanelControl final : public QObject {
    Q_OBJECT
public:
    static constexpr double kAnswersWithin = 0.1;  ///< [s]
    static constexpr double kLostAfter = 0.3;      ///< [s]
    static constexpr double kApproveHold = 1.5;    ///< [s] hold time, equal to the screen's
    static constexpr double kBuzz = 0.5;           ///< [s] duration of one sound
    static constexpr double kAskAgain = 10.0;      ///< [s] between two sounds for one proposal

    /// Exploration and source must outlive the object.
    PanelControl(std::unique_ptr<OperatorPanel> panel, MeasurementSource& source,
                 Exploration& exploration);

    /// State of the window that the panel depends on.
    struct ViewState {
        bool mayExplore = false;         ///< the window's button would start an exploration
        std::optional<quint64> shown{};  ///< proposal that is visible to the operator
        bool covered = false;            ///< the proposal is hidden only by another window
        bool mayAsk = true;              ///< a proposal may use the buzzer
    };
    /// Polls the panel. An approval needs its contact held for kApproveHold while the proposal stays visible. A press
    /// from before the proposal does not count.
    void tick(double now, const ViewState& viewState);
    void buzz();  ///< starts the buzzer once, with a sound of the console

    /// Returns true if the panel was read recently; an armed robot requires it (dead-man condition).
    bool answers(double now) const;
    bool isLost() const { return now_ - answeredAt_ > kLostAfter; }  ///< lost, not only late
    bool stopPressed() const { return report_.state.stop; }
    const PanelState& state() const { return report_.state; }
    Precondition precondition(double now) const;
    std::optional<Message>
    whyNotReleased() const;  ///< why STOP cannot be released at the window; empty: it can
    const PanelReader& reader() const { return reader_; }
    const PanelReport& report() const { return report_; }

signals:
    void happened(const terratact::Message& text, terratact::EventSeverity severity);

private:
    void press(const ViewState& viewState);
    void approve(quint64 asked, bool pressed, bool covered);
    void ask(const ViewState& viewState);
    void light();

    Exploration& exploration_;
    PanelReader reader_;
    PanelReport report_;
    double now_ = 0.0;         ///< [s]
    double answeredAt_ = 0.0;  ///< [s]
    bool wasStopped_ = true;
    std::optional<quint64> shown_;
    double shownSince_ = 0.0;      ///< [s]
    bool approving_ = false;       ///< the contact is held, but not long enough yet
    std::optional<double> asked_;  ///< [s] time of the last sound for a proposal
    double buzzUntil_ = 0.0;       ///< [s]
    Message trouble_;
};

}  // namespace terratact
