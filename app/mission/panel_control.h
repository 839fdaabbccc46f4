#pragma once

#include <memory>

#include "app/link/panel_reader.h"
#include "app/mission/exploration.h"

namespace terratact {

/// Means by the panel's buttons what the window's buttons mean, and lights its lamps.  GUI thread only.
class PanelControl final : public QObject {
    Q_OBJECT
public:
    static constexpr double kAnswersWithin = 0.1;  ///< [s]
    static constexpr double kLostAfter = 0.3;      ///< [s]
    static constexpr double kApproveHold = 1.5;    ///< [s] as on the screen
    static constexpr double kBuzz = 0.5;           ///< [s] of one sound
    static constexpr double kAskAgain = 10.0;      ///< [s] between two sounds of one question

    /// Exploration and source must outlive it.
    PanelControl(std::unique_ptr<OperatorPanel> panel, MeasurementSource& source,
                 Exploration& exploration);

    /// What the window shows at one time.
    struct ViewState {
        bool mayExplore = false;         ///< its button that asks for an exploration would do so
        std::optional<quint64> shown{};  ///< the proposal that the operator has before him
        bool covered = false;            ///< there it is, but for another window that covers it
        bool mayAsk = true;              ///< a question may sound
    };
    /// An approval needs its contact held for kApproveHold with the question before the operator all the time: what
    /// was pressed before is no answer to it.
    void tick(double now, const ViewState& viewState);
    void buzz();  ///< once: something of the console's sounds

    /// The panel is there and was read lately: what an armed robot needs of it.
    bool answers(double now) const;
    bool isLost() const { return now_ - answeredAt_ > kLostAfter; }  ///< not only late
    bool stopPressed() const { return report_.state.stop; }
    const PanelState& state() const { return report_.state; }
    Precondition precondition(double now) const;
    QString whyNotReleased() const;  ///< STOP, by the window; empty: it may be
    const PanelReader& reader() const { return reader_; }
    const PanelReport& report() const { return report_; }

signals:
    void happened(const QString& text, terratact::Weight weight);

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
    bool approving_ = false;       ///< the contact is held, not yet long enough
    std::optional<double> asked_;  ///< [s] when the question sounded last
    double buzzUntil_ = 0.0;       ///< [s]
    QString trouble_;
};

}  // namespace terratact
