#pragma once

#include <optional>

#include "core/atem/atem_machine.h"
#include "core/atem/phase_time.h"
#include "widgets/card.h"
#include "widgets/precondition.h"

class QBoxLayout;
class QGridLayout;
class QLabel;
class QPushButton;

namespace terratact {

class HoldToConfirmButton;
class ScrollColumn;

/// What the operator sees and may do of an exploration: the state in words with the time it has left,
/// the preconditions, and the buttons that request it, end it, or release STOP.
class AtemPanel final : public Card {
    Q_OBJECT
public:
    explicit AtemPanel(QWidget* parent = nullptr);

    /// said: where more is known than the state itself says; empty: its own.
    void setState(const AtemState& state, const std::optional<PhaseTime>& time,
                  const QString& said = {});
    /// The request is possible unless one is Missing or Doubtful.  While an exploration runs, those that are met are not
    /// shown: their room is the probe's.
    void setPreconditions(const QList<Precondition>& preconditions);

    void setReleasing(const QList<Precondition>& preconditions);  ///< of releasing STOP, as its tip
    /// There is something on the screen that can be taken off it, in whatever state.
    void setResultStands(bool stands);

    /// From now on it only shows: no button is seen.
    void forbidCommands();
    /// Little room: the buttons below each other, and while an exploration runs only the state with the button that
    /// ends it.
    void setNarrow(bool narrow);
    int leastHeight() const;  ///< [px] while an exploration runs

    QPushButton* requestButton() const { return request_; }
    QPushButton* abortButton() const { return abort_; }
    HoldToConfirmButton* releaseButton() const { return release_; }
    QPushButton* overrideButton() const { return override_; }

signals:
    void requested();
    void aborted();
    void stopReleased();
    void overrideWanted();

private:
    void showList();
    void showButtons();
    void arrange();
    static QString timeWords(const PhaseTime& time);

    AtemState state_;
    bool onlyShows_ = false;
    bool narrow_ = false;
    bool resultStands_ = false;
    QList<Precondition> preconditions_, shown_;
    QLabel* stateText_ = nullptr;
    QLabel* timeText_ = nullptr;
    QGridLayout* list_ = nullptr;
    ScrollColumn* texts_ = nullptr;
    QBoxLayout* parts_ = nullptr;    ///< texts and buttons
    QBoxLayout* buttons_ = nullptr;  ///< the request and the others
    QPushButton* request_ = nullptr;
    QPushButton* abort_ = nullptr;
    QPushButton* override_ = nullptr;
    HoldToConfirmButton* release_ = nullptr;
};

}  // namespace terratact
