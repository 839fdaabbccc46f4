#pragma once

#include <array>
#include <optional>

#include "core/atem/atem_machine.h"
#include "core/atem/phase_time.h"
#include "widgets/base/card.h"
#include "widgets/control/precondition.h"

class QBoxLayout;
class QGridLayout;
class QLabel;
class QPushButton;

namespace terratact {

class HoldToConfirmButton;
class ScrollColumn;

/// What the operator sees and may do of an exploration: the state in words with the time it has left,
/// the preconditions, and the buttons that request it, end it, or release STOP.
///
/// The preconditions are those of the command that comes next: exploring, the probe that is asked for, or releasing
/// STOP.  Those of any other command can be looked up; the state's next change ends that.
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

    /// Of any command; of exploring it is the same as setPreconditions().  Empty: it is not given from here.
    void setNeeds(Commanded command, const QList<Precondition>& preconditions);
    void lookUp(std::optional<Commanded> command);  ///< empty: what comes next
    void lookUpNext();                              ///< one after the other, then what comes next
    Commanded listed() const;                       ///< whose preconditions are shown
    /// There is something on the screen that can be taken off it, in whatever state.
    void setResultStands(bool stands);

    /// The bin of which the operator may ask for a probe now, with what that would tell; empty: none.  Its button stands in
    /// the place of the one that forgets.
    void setProbeToAsk(std::optional<int> bin, const QString& tells);

    /// From now on it only shows: no button is seen.
    void forbidCommands();
    /// Little room: the buttons below each other, and while an exploration runs only the state with the button that
    /// ends it.
    void setNarrow(bool narrow);
    int leastHeight() const;  ///< [px] while an exploration runs

    QPushButton* requestButton() const { return request_; }
    QPushButton* abortButton() const { return abort_; }
    QPushButton* askButton() const { return ask_; }
    HoldToConfirmButton* releaseButton() const { return release_; }
    QPushButton* overrideButton() const { return override_; }
    QPushButton* needsButton() const { return needsButton_; }  ///< whose menu looks up

signals:
    void requested();
    void aborted();
    void forgetWanted();
    void probeWanted(int bin);
    void stopReleased();
    void overrideWanted();

private:
    void showState();
    QString idleWords(const QString& ready) const;
    void showList();
    void showButtons();
    bool forgets() const;
    void arrange();
    Commanded next() const;
    QList<Precondition> needsNow(Commanded command) const;
    QList<Precondition> listOf(Commanded command) const;
    void offerCommands();
    static QString timeWords(const PhaseTime& time);

    AtemState state_;
    QString said_;  ///< of it
    bool onlyShows_ = false;
    bool narrow_ = false;
    bool resultStands_ = false;
    std::array<QList<Precondition>, kCommanded.size()> needs_;
    std::optional<Commanded> lookedUp_;
    QList<Precondition> shown_;
    QLabel* subject_ = nullptr;  ///< whose they are, where that is not exploring
    QPushButton* needsButton_ = nullptr;
    QLabel* stateText_ = nullptr;
    QLabel* timeText_ = nullptr;
    QGridLayout* list_ = nullptr;
    ScrollColumn* texts_ = nullptr;
    QBoxLayout* parts_ = nullptr;    ///< texts and buttons
    QBoxLayout* buttons_ = nullptr;  ///< the request and the others
    QPushButton* request_ = nullptr;
    QPushButton* abort_ = nullptr;  ///< an exploration, or forgets what has come of it
    QPushButton* ask_ = nullptr;
    std::optional<int> askBin_;
    QString askTells_;
    QPushButton* override_ = nullptr;
    HoldToConfirmButton* release_ = nullptr;
};

}  // namespace terratact
