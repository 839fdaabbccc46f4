#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/atem/probe_gain.h"
#include "core/infer/verdict/verdict.h"
#include "core/limits.h"
#include "widgets/base/card.h"
#include "widgets/control/precondition.h"

class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedLayout;

namespace terratact {

class HoldToConfirmButton;
class ScrollColumn;
enum class Tone;

/// What touching one bin is expected to buy.
struct ProbeWorth {
    int bin = 0;
    double varianceShare = 0.0;  ///< 0 … 1 of the total variance of all bins, gone
    double bitsAfter = 0.0;      ///< entropy of the question "is there a step ahead?" [bit]
    bool operator==(const ProbeWorth&) const = default;
};

/// A probe as it is put to the operator.  An answer carries the proposal's id, so that it can only
/// mean what was on the screen.
struct ProbeProposal {
    quint64 id = 0;
    int bin = 0;
    double height = 0.0, q10 = 0.0, q90 = 0.0, sd = 0.0;  ///< [m]
    double limit = kProbeThreshold;   ///< [m] sd above which the arm is asked for
    double armSd = 0.03;              ///< [m] sd of what the arm would measure
    double seconds = 45.0;            ///< what it costs
    double stepLimit = 0.1;           ///< [m] of the question
    double bitsBefore = 0.0;          ///< its entropy now [bit]
    std::optional<ProbeWorth> worth;  ///< of this bin; empty: the method cannot tell
    std::vector<ProbeWorth> others;   ///< the bins the operator may choose instead, the best first
    StepVerdict answer = StepVerdict::CannotTell;  ///< that the estimate gives without the probe

    /// The probe says something about the question; else, where its worth is known, only about the terrain's shape.
    bool tellsOfStep() const { return worth && bitsBefore - worth->bitsAfter >= kMinBits; }
    bool operator==(const ProbeProposal&) const = default;
};

/// The card that asks for the arm: where, what is expected there, what it buys and costs, what else could be
/// touched, and how long the question stands.  Approving takes a hold of 1.5 s of what is shown(), all the time;
/// refusing a click; no answer means no.
/// Where the estimate has an answer without the arm, the card says so, and not to probe is what stands out.  Where
/// nobody is asked it says the same to be read only, below why that is.
class ProbeCard final : public Card {
    Q_OBJECT
public:
    explicit ProbeCard(QWidget* parent = nullptr);

    void setProposal(const ProbeProposal& proposal);
    void setTimeLeft(double seconds);
    /// Of approving, as its tip.  Where one is missing the question is void: it cannot be approved, and says why.
    void setPreconditions(const QList<Precondition>& preconditions);
    /// The arm is on its way to `bin` for `elapsed` of about `expected` seconds.
    void setProbing(int bin, double elapsed, double expected);
    /// What the probe would buy that nobody is asked for here, and why not; its id and answer do not matter.
    void setWorth(const ProbeProposal& probe, const QString& why);
    void setNothing(const QString& why);

    /// Little room: the same in fewer words.
    void setNarrow(bool narrow);
    int leastHeight() const;  ///< [px] of a question, asked or not
    int givenHeight() const;  ///< [px] more, and all its lines are seen

    bool asks() const;                                             ///< a proposal is on the card
    bool isVoid() const { return asks() && !whyVoid_.isEmpty(); }  ///< and cannot be approved
    bool tells() const;  ///< what a probe would buy, without asking for it
    /// The proposal that the operator has before him, by its id: the card is seen and was painted with it.
    std::optional<quint64> shown() const;
    /// By another window of this one's, such as a file dialog, or by a menu that is open; in part is enough.
    bool isCovered() const;
    HoldToConfirmButton* approveButton() const { return approve_; }
    QPushButton* refuseButton() const { return refuse_; }
    QPushButton* otherButton(std::size_t i) const { return others_.at(i); }
    static constexpr std::size_t kOthers = 3;

protected:
    void paintEvent(QPaintEvent* event) override;

signals:
    void approved(quint64 id);
    void refused(quint64 id);
    void otherChosen(quint64 id, int bin);

private:
    QLabel* fact(QGridLayout& rows, const QString& name, Tone tone);
    QWidget* questionPage();
    QWidget* answers();
    QWidget* probingPage();
    const ProbeProposal* told() const;  ///< what the facts are of; null: of nothing
    void showFacts();
    void showWorth();
    QString questionText() const;
    void showAnswer();
    void showApproval();
    void showOthers();
    void showRanking();
    void showPage(int page);

    std::optional<ProbeProposal> proposal_,
        worth_;            ///< asked for; only told.  One of them, or neither
    QString whyNotAsked_;  ///< of worth_
    QString whyVoid_;      ///< of proposal_; empty: it may be approved
    quint64 painted_ = 0;  ///< id of the proposal that was painted last
    QStackedLayout* pages_ = nullptr;
    QLabel* nothing_ = nullptr;
    QLabel* where_ = nullptr;
    QLabel* predicted_ = nullptr;
    QLabel* band_ = nullptr;
    QLabel* variance_ = nullptr;
    QLabel* question_ = nullptr;
    QLabel* questionKey_ = nullptr;
    QLabel* decided_ = nullptr;  ///< that there is an answer already, or why nobody is asked
    QLabel* ranking_ = nullptr;  ///< the other bins, where they cannot be chosen
    QList<QLabel*> keys_;
    ScrollColumn* facts_ = nullptr;
    QWidget* asking_ = nullptr;
    QWidget* answers_ = nullptr;  ///< of it
    bool narrow_ = false;
    QLabel* cost_ = nullptr;
    QLabel* costKey_ = nullptr;
    QGridLayout* lines_ = nullptr;  ///< of the facts
    int costLine_ = 0;
    HoldToConfirmButton* approve_ = nullptr;
    QPushButton* refuse_ = nullptr;
    std::array<QPushButton*, kOthers> others_{};
    QLabel* probingText_ = nullptr;
    QProgressBar* probingBar_ = nullptr;
};

}  // namespace terratact
