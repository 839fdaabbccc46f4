#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/display/precondition.h"
#include "app/display/tone.h"
#include "core/atem/probe/probe_proposal.h"
#include "widgets/base/card.h"

class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedLayout;

namespace terratact {

class HoldToConfirmButton;
class ScrollColumn;

/// The card that proposes a probe: the bin, its expected height, the gain, the cost, alternatives and the approval
/// expiry. Approving takes a 1.5 s hold while the proposal stays shown(); refusing takes a click; no answer means no.
/// If the estimate already has a verdict, the card shows it and highlights not probing. If no probe is proposed, the
/// card shows the same facts read-only, and why.
class ProbeCard final : public Card {
    Q_OBJECT
public:
    explicit ProbeCard(QWidget* parent = nullptr);

    void setProposal(const ProbeProposal& proposal);
    void setTimeLeft(double seconds);
    /// Sets the preconditions of approving, shown as its tip. A Missing one makes the proposal void: it cannot be
    /// approved, and the card gives the reason.
    void setPreconditions(const QList<Precondition>& preconditions);
    /// Shows that the arm has been probing a place for `elapsed` of about `expected` seconds.
    void setProbing(ProbePlace place, double elapsed, double expected);
    /// Shows the expected gain of a probe that is not proposed, and why not. The probe's id and answer are ignored.
    void setWorth(const ProbeProposal& probe, const QString& why);
    void setNothing(const QString& why);

    /// Compact layout with shorter texts.
    void setNarrow(bool narrow);
    int leastHeight() const;  ///< [px] minimum height with proposal or worth
    int givenHeight() const;  ///< [px] extra height at which all lines are visible

    bool asks() const;  ///< true if a proposal is on the card
    /// Returns true if the proposal cannot be approved.
    bool isVoid() const { return asks() && !whyVoid_.isEmpty(); }
    bool showsWorth() const;  ///< true if the card shows a probe's worth without proposing it
    /// Returns the id of the proposal the operator sees: the card is visible and was painted with it.
    std::optional<quint64> shown() const;
    HoldToConfirmButton* approveButton() const { return approve_; }
    QPushButton* refuseButton() const { return refuse_; }
    QPushButton* otherButton(std::size_t i) const { return others_.at(i); }
    static constexpr std::size_t kOthers = 3;

protected:
    void paintEvent(QPaintEvent* event) override;

signals:
    void approved(quint64 id);
    void refused(quint64 id);
    void otherChosen(quint64 id, terratact::ProbePlace place);

private:
    QLabel* fact(QGridLayout& rows, const QString& name, Tone tone);
    QWidget* questionPage();
    QWidget* answers();
    QWidget* probingPage();
    const ProbeProposal* displayed() const;  ///< probe that the facts describe; null: none
    void showFacts();
    void showWorth();
    QString questionText() const;
    void showAnswer();
    void showApproval();
    void showOthers();
    void showRanking();
    void showPage(int page);

    std::optional<ProbeProposal> proposal_,
        worth_;            ///< proposed; shown without proposing. At most one is set
    QString whyNotAsked_;  ///< reason that worth_ is not proposed
    QString whyVoid_;      ///< reason that proposal_ is void; empty: it may be approved
    quint64 painted_ = 0;  ///< id of the last painted proposal
    QStackedLayout* pages_ = nullptr;
    QLabel* nothing_ = nullptr;
    QLabel* where_ = nullptr;
    QLabel* predicted_ = nullptr;
    QLabel* band_ = nullptr;
    QLabel* variance_ = nullptr;
    QLabel* question_ = nullptr;
    QLabel* questionKey_ = nullptr;
    /// States that a verdict exists already, or why no probe is proposed.
    QLabel* decided_ = nullptr;
    QLabel* ranking_ = nullptr;  ///< other bins while they cannot be chosen
    QList<QLabel*> keys_;
    ScrollColumn* facts_ = nullptr;
    QWidget* asking_ = nullptr;
    QWidget* answers_ = nullptr;  ///< approve and refuse buttons
    bool narrow_ = false;
    QLabel* cost_ = nullptr;
    QLabel* costKey_ = nullptr;
    QGridLayout* lines_ = nullptr;  ///< rows of the facts
    int costLine_ = 0;
    HoldToConfirmButton* approve_ = nullptr;
    QPushButton* refuse_ = nullptr;
    std::array<QPushButton*, kOthers> others_{};
    QLabel* probingText_ = nullptr;
    QProgressBar* probingBar_ = nullptr;
};

}  // namespace terratact
