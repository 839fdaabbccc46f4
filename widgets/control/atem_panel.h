#pragma once

#include <array>
#include <optional>

#include "app/display/precondition.h"
#include "core/atem/atem_machine.h"
#include "core/atem/phase_time.h"
#include "core/robot/probe_side.h"
#include "widgets/base/card.h"

class QBoxLayout;
class QLabel;
class QPushButton;

namespace terratact {

class HoldToConfirmButton;
class PreconditionGrid;
class ScrollColumn;

/// A probe for which the operator may ask.
struct ProbeToAsk {
    std::optional<ProbePlace> place{};  ///< empty: there is no place to probe
    QString text{};                     ///< expected gain, or why there is no place
    bool operator==(const ProbeToAsk&) const = default;
};

/// The operator's panel of an exploration. It shows the state with the time left, and the preconditions. Its buttons
/// request it, abort it or release STOP.
///
/// The listed preconditions belong to the next command: exploring, the proposed probe, or releasing STOP. Preconditions
/// of other commands can be looked up; the next state change ends the look-up.
class AtemPanel final : public Card {
    Q_OBJECT
public:
    explicit AtemPanel(QWidget* parent = nullptr);

    /// said: text that replaces the state's own text; empty: the state's own.
    void setState(const AtemState& state, const std::optional<PhaseTime>& time,
                  const QString& said = {});
    /// The request is enabled unless a precondition is Missing or Doubtful. While an exploration runs, met
    /// preconditions are hidden to leave room for the probe.
    void setPreconditions(const QList<Precondition>& preconditions);

    /// Sets the preconditions of any command; Explore equals setPreconditions(). An empty list means this console does
    /// not give the command.
    void setNeeds(Commanded command, const QList<Precondition>& preconditions);
    void lookUp(std::optional<Commanded> command);  ///< empty: the next command
    void lookUpNext();         ///< cycles through the commands, then back to the next command
    Commanded listed() const;  ///< command whose preconditions are listed
    /// Sets whether the screen shows an estimate that can be cleared, in any state.
    void setHasResult(bool hasResult);

    /// Offers to request a probe; empty: no offer. Its button replaces the one that clears the estimate. Where the
    /// probe is not possible now, the button is disabled and its tip gives the reason; it then stands beside the other.
    /// While an exploration runs, the button is hidden: the probe card then has the proposal.
    void setProbeToAsk(const std::optional<ProbeToAsk>& probe);

    /// Makes the panel display-only: no button is visible.
    void forbidCommands();
    /// Compact layout: buttons stand below each other. While an exploration runs, only the state and the button that
    /// ends it remain.
    void setNarrow(bool narrow);
    int leastHeight() const;  ///< [px] minimum height while an exploration runs

    QPushButton* requestButton() const { return request_; }
    QPushButton* abortButton() const { return abort_; }
    HoldToConfirmButton* releaseButton() const { return release_; }
    QPushButton* overrideButton() const { return override_; }
    QPushButton* probeButton() const { return ask_; }
    /// Returns the button whose menu looks up the preconditions of a command.
    QPushButton* needsButton() const { return needsButton_; }

signals:
    void requested();
    void aborted();
    void forgetWanted();
    void probeWanted(terratact::ProbePlace place);
    void stopReleased();
    void overrideWanted();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showState();
    QString idleText(const QString& ready) const;
    void showList();
    void showButtons();
    void showProbe(bool possible, const QString& whyNot);
    void placeButtons();
    bool forgets() const;
    void arrange();
    Commanded next() const;
    QList<Precondition> needsNow(Commanded command) const;
    QList<Precondition> listOf(Commanded command) const;
    void offerCommands();
    static QString timeText(const PhaseTime& time);

    AtemState state_;
    QString said_;  ///< text that replaces the state's own
    bool onlyShows_ = false;
    bool narrow_ = false;
    bool stacks_ = false;  ///< the buttons stand one above the other even if they fit side by side
    bool hasResult_ = false;
    std::array<QList<Precondition>, kCommanded.size()> needs_;
    std::optional<Commanded> lookedUp_;
    QLabel* subject_ = nullptr;  ///< names the command, unless it is exploring
    QPushButton* needsButton_ = nullptr;
    QLabel* stateText_ = nullptr;
    QLabel* timeText_ = nullptr;
    PreconditionGrid* list_ = nullptr;
    ScrollColumn* texts_ = nullptr;
    QBoxLayout* parts_ = nullptr;    ///< texts beside buttons
    QBoxLayout* buttons_ = nullptr;  ///< request button beside the others
    QBoxLayout* others_ = nullptr;   ///< below each other if their words do not fit
    QPushButton* request_ = nullptr;
    QPushButton* abort_ = nullptr;  ///< aborts an exploration, or clears its result
    QPushButton* ask_ = nullptr;
    std::optional<ProbeToAsk> probe_;
    QPushButton* override_ = nullptr;
    HoldToConfirmButton* release_ = nullptr;
};

}  // namespace terratact
