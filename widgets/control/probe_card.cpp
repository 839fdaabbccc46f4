#include "widgets/control/probe_card.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedLayout>
#include <QStyle>
#include <QVBoxLayout>
#include <cmath>

#include "app/display/format.h"
#include "app/display/place_text.h"
#include "app/display/translated.h"
#include "widgets/base/held_button.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/scroll_column.h"
#include "widgets/base/spoken.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/covered.h"

namespace terratact {
namespace {

enum Page { kNothing, kQuestion, kProbing };
constexpr int kFacts = 6;           // lines
constexpr int kMinFacts = 4;        // visible lines at the minimum height
constexpr int kProbeGap = 6;        // [px] between facts and answers
constexpr double kFineBand = 0.02;  // [m] a narrower band is shown in millimetres

QString percent(double share)
{
    return format::number(-100.0 * share, 0);
}

ProbePlace placeOf(const ProbeProposal& proposal)
{
    return {proposal.bin, proposal.side};
}

}  // namespace

ProbeCard::ProbeCard(QWidget* parent) : Card(tr("Arm probe"), parent)
{
    pages_ = new QStackedLayout;
    body()->addLayout(pages_, 1);

    nothing_ = new PlainLabel(this);
    nothing_->setWordWrap(true);
    nothing_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setTone(*nothing_, Tone::Muted);
    pages_->addWidget(nothing_);

    asking_ = questionPage();
    pages_->addWidget(asking_);
    pages_->addWidget(probingPage());
    approve_->setMayHold([this] { return shown().has_value(); });
    connect(approve_, &HoldToConfirmButton::confirmed, this, [this] {
        if (const auto id = shown()) emit approved(*id);
    });
    connect(refuse_, &QPushButton::clicked, this, [this] {
        if (asks()) emit refused(proposal_->id);
    });
    setNarrow(false);
    setNothing(QString());
}

QLabel* ProbeCard::fact(QGridLayout& rows, const QString& name, Tone tone)
{
    auto* key = new PlainLabel(name, this);
    setTone(*key, Tone::Muted);
    key->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* value = new PlainLabel(this);
    setTone(*value, tone);
    value->setAccessibleName(name);
    value->setWordWrap(true);
    value->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    keys_ << key;
    const int at = rows.rowCount();
    rows.addWidget(key, at, 0);
    rows.addWidget(value, at, 1);
    return value;
}

QWidget* ProbeCard::questionPage()
{
    auto* question = new QWidget(this);
    facts_ = new ScrollColumn(kMinFacts, question);
    facts_->setAccessibleName(tr("Expected gain of the probe"));
    auto* rows = new QGridLayout;
    rows->setHorizontalSpacing(14);
    rows->setVerticalSpacing(0);
    rows->setColumnStretch(1, 1);
    where_ = fact(*rows, tr("where"), Tone::Accent);
    predicted_ = fact(*rows, tr("predicted"), Tone::Strong);
    band_ = fact(*rows, tr("80 % band"), Tone::Strong);
    variance_ = fact(*rows, tr("all bins"), Tone::Strong);
    cost_ = fact(*rows, tr("costs"), Tone::Strong);
    costKey_ = keys_.last();
    costLine_ = rows->rowCount() - 1;
    question_ = fact(*rows, tr("step ahead"), Tone::Strong);
    questionKey_ = keys_.last();
    decided_ = new PlainLabel(question);
    decided_->setWordWrap(true);
    decided_->setAccessibleName(tr("Need for a probe"));
    setTone(*decided_, Tone::Good);
    facts_->column()->addWidget(decided_);
    facts_->column()->addLayout(rows, 2);
    ranking_ = new PlainLabel(question);
    ranking_->setWordWrap(true);
    ranking_->setAccessibleName(tr("The other bins, the best first"));
    setTone(*ranking_, Tone::Muted);
    facts_->column()->addWidget(ranking_);
    // Extra room goes between the lines and above the first, so that the facts are readable at a glance. Row 0 of the
    // grid is empty.
    for (int line = 0; line < rows->rowCount(); ++line) rows->setRowStretch(line, 1);
    lines_ = rows;
    facts_->column()->addStretch(1);

    answers_ = answers();
    auto* column = new QVBoxLayout(question);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kProbeGap);
    column->addWidget(facts_, 1);
    column->addWidget(answers_);
    return question;
}

QWidget* ProbeCard::answers()
{
    auto* all = new QWidget(this);
    auto* instead = new QHBoxLayout;
    instead->setSpacing(kProbeGap);
    for (std::size_t i = 0; i < kOthers; ++i) {
        others_[i] = new QPushButton(all);
        others_[i]->setFocusPolicy(Qt::TabFocus);
        others_[i]->setProperty("role", "compact");
        instead->addWidget(others_[i], 1);
        connect(others_[i], &QPushButton::clicked, this, [this, i] {
            if (asks() && i < proposal_->others.size())
                emit otherChosen(proposal_->id, proposal_->others[i].place());
        });
    }
    approve_ = new HoldToConfirmButton(QString(), &Theme::decide, all);
    setPreconditions({});
    refuse_ = new QPushButton(all);
    refuse_->setFocusPolicy(Qt::TabFocus);
    setTip(*refuse_, tr("Refuses the probe; the estimate stays as it is"));
    auto* column = new QVBoxLayout(all);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kProbeGap);
    column->addLayout(instead);
    column->addWidget(approve_);
    column->addWidget(refuse_);
    return all;
}

QWidget* ProbeCard::probingPage()
{
    auto* probing = new QWidget(this);
    auto* column = new QVBoxLayout(probing);
    column->setContentsMargins(0, 0, 0, 0);
    probingText_ = new PlainLabel(probing);
    probingText_->setWordWrap(true);
    setTone(*probingText_, Tone::Accent);
    probingBar_ = new QProgressBar(probing);
    probingBar_->setRange(0, 1000);
    probingBar_->setAccessibleName(tr("Progress of the probe"));
    column->addWidget(probingText_);
    column->addWidget(probingBar_);
    column->addStretch(1);
    return probing;
}

void ProbeCard::setNarrow(bool narrow)
{
    narrow_ = narrow;
    where_->setVisible(!narrow);  // other lines repeat it
    for (QLabel* key : std::as_const(keys_)) key->setVisible(!narrow);
    displayed() ? showFacts() : showAnswer();
}

int ProbeCard::leastHeight() const
{
    const QSize buttons =
        answers_->layout()->totalMinimumSize();  // the buttons are hidden or shown together
    return frameHeight() + facts_->minimumSizeHint().height() + kProbeGap + buttons.height();
}

int ProbeCard::givenHeight() const
{
    const int lines = kFacts - kMinFacts;
    return lines * (facts_->fontMetrics().lineSpacing() + facts_->column()->spacing());
}

void ProbeCard::showPage(int page)
{
    for (int i = 0; i < pages_->count(); ++i) {  // hidden pages take no height
        const auto policy = i == page ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        pages_->widget(i)->setSizePolicy(policy, policy);
    }
    pages_->setCurrentIndex(page);
}

bool ProbeCard::asks() const
{
    return proposal_.has_value();
}

bool ProbeCard::showsWorth() const
{
    return worth_.has_value();
}

const ProbeProposal* ProbeCard::displayed() const
{
    return proposal_ ? &*proposal_ : worth_ ? &*worth_ : nullptr;
}

std::optional<quint64> ProbeCard::shown() const
{
    if (!proposal_ || painted_ != proposal_->id) return std::nullopt;
    if (!isVisible() || window()->isMinimized() || isCovered(*this)) return std::nullopt;
    return proposal_->id;
}

void ProbeCard::paintEvent(QPaintEvent* event)
{
    Card::paintEvent(event);
    if (proposal_) painted_ = proposal_->id;
}

void ProbeCard::setProposal(const ProbeProposal& proposal)
{
    if (proposal_ == proposal) return;
    // A hold that began on another proposal does not count for this one.
    const bool isNew = !proposal_ || proposal_->id != proposal.id;
    if (isNew) {
        approve_->letGo();
        whyVoid_.clear();
    }
    proposal_ = proposal;
    worth_.reset();
    showFacts();
    showApproval();
    showPage(kQuestion);
    update();  // repaints the whole card, so that painted_ holds
    if (isNew) announce(*this);
}

void ProbeCard::setWorth(const ProbeProposal& probe, const QString& why)
{
    if (worth_ == probe && whyNotAsked_ == why) return;
    proposal_.reset();
    worth_ = probe;
    whyNotAsked_ = why;
    setNote(tr("no probe is proposed"), Tone::Muted);
    showFacts();
    showPage(kQuestion);
}

void ProbeCard::showFacts()
{
    where_->setText(binText(placeOf(*displayed())));
    answers_->setVisible(asks());
    showAnswer();
    showWorth();
    const QLabel* const lines[]{where_, predicted_, band_, variance_, question_};
    QStringList all;
    if (isVoid()) all << decided_->text();
    for (const QLabel* line : lines) all << line->text();
    setAccessibleDescription(all.join(QStringLiteral("; ")));
}

void ProbeCard::showWorth()
{
    const ProbeProposal& p = *displayed();
    const int decimals = p.q90 - p.q10 < kFineBand ? 3 : 2;
    const QString height = narrow_ ? format::signedLengthNumber(p.height, decimals)
                                   : format::signedLength(p.height, decimals);
    const QString sd = format::length(p.sd, decimals);
    const QString q10 = format::signedLengthNumber(p.q10, decimals),
                  q90 = format::signedLength(p.q90, decimals);
    const QString seconds = format::number(p.seconds, 0);
    predicted_->setText(narrow_ ? tr("%1: %2 ± %3").arg(placeText(placeOf(p)), height, sd)
                                : tr("%1 ± %2 (sd)").arg(height, sd));
    band_->setText(narrow_ ? tr("80 % in %1 … %2").arg(q10, q90) : tr("%1 … %2").arg(q10, q90));
    const QString worth = p.worth ? tr("total variance %1 %").arg(percent(p.worth->varianceShare))
                                  : tr("this bin to ± %1").arg(format::length(p.armSd, 2));
    // Cost and variance share a line if the card shows more facts.
    const bool joined = narrow_ || showsWorth() || isVoid() || p.answer != StepVerdict::CannotTell;
    for (QLabel* label : {cost_, costKey_}) label->setVisible(!joined);
    lines_->setRowStretch(costLine_, joined ? 0 : 1);
    variance_->setText(joined ? tr("%1 for %2 s").arg(worth, seconds) : worth);
    cost_->setText(tr("≈ %1 s, arm out in smoke").arg(seconds));
    questionKey_->setText(tr("step > %1").arg(format::length(p.stepLimit, 2)));
    question_->setText(questionText());
    showOthers();
    showRanking();
}

QString ProbeCard::questionText() const
{
    const ProbeProposal& p = *displayed();
    if (!p.worth)
        return narrow_ ? tr("step: not known for this method") : tr("not known for this method");
    const QString before = format::number(p.bitsBefore, 2);
    if (!p.informsOnStep()) {
        if (!narrow_) return tr("%1 bit, no gain").arg(before);
        return p.answer == StepVerdict::CannotTell
                 ? tr("step: %1 bit, no gain").arg(before)
                 : tr("Already %1; no gain").arg(translated(describe(p.answer)));
    }
    const QString after = format::number(p.worth->bitsAfter, 2);
    const QString rate = format::number(60.0 * (p.bitsBefore - p.worth->bitsAfter) / p.seconds, 2);
    return (narrow_ ? tr("step: %1 → %2 bit, %3/min") : tr("%1 → %2 bit: %3/min"))
        .arg(before, after, rate);
}

void ProbeCard::showAnswer()
{
    setTone(*decided_, isVoid() ? Tone::Bad : asks() ? Tone::Good : Tone::Muted);
    if (showsWorth()) {
        decided_->setText(whyNotAsked_);
        decided_->setVisible(!whyNotAsked_.isEmpty());
        return;
    }
    const bool decided = proposal_ && proposal_->answer != StepVerdict::CannotTell;
    const QString answer = decided ? translated(describe(proposal_->answer)) : QString();
    decided_->setVisible(isVoid() || (decided && !narrow_ && proposal_->worth));
    if (isVoid())
        decided_->setText(tr("Cannot be approved: %1").arg(whyVoid_));
    else if (decided)
        decided_->setText((proposal_->informsOnStep()
                               ? tr("Already %1; a probe makes it more certain.")
                               : tr("Already %1; a probe only refines the profile."))
                              .arg(answer));
    refuse_->setText(narrow_   ? tr("Do not probe (N)")
                     : decided ? tr("Do not probe: 0 s, keep %1 (N)").arg(answer)
                               : tr("Do not probe: 0 s, the estimate stays (N)"));
    const QString role = decided ? QStringLiteral("primary") : QString();
    if (refuse_->property("role").toString() == role) return;
    refuse_->setProperty("role", role);
    refuse_->style()->unpolish(refuse_);
    refuse_->style()->polish(refuse_);
}

void ProbeCard::showOthers()
{
    const std::vector<ProbeWorth> offered =
        displayed() ? displayed()->others : std::vector<ProbeWorth>();
    for (std::size_t i = 0; i < kOthers; ++i) {
        others_[i]->setVisible(i < offered.size());
        others_[i]->setEnabled(!isVoid());
        if (i >= offered.size()) continue;
        const ProbeWorth& other = offered[i];
        const QString place = shortPlace(other.place());
        others_[i]->setText(
            narrow_ ? QStringLiteral("%1: %2").arg(i + 1).arg(place)
                    : tr("%1: %2, %3 %").arg(i + 1).arg(place, percent(other.varianceShare)));
        const QString all = tr("Ask for %1 instead: total variance %2 %, step ahead to %3 bit")
                                .arg(binText(other.place()), percent(other.varianceShare),
                                     format::number(other.bitsAfter, 2));
        setTip(*others_[i], isVoid() ? tr("Cannot be approved: %1").arg(whyVoid_) : all);
        others_[i]->setAccessibleName(all);
    }
}

void ProbeCard::showRanking()
{
    QStringList bins;  // one bin per line, because wrapped lines cannot be compared
    for (const ProbeWorth& other : displayed()->others) {
        if (bins.size() == static_cast<qsizetype>(kOthers)) break;
        bins << tr("or %1: %2 %, %3 bit")
                    .arg(placeText(other.place()), percent(other.varianceShare),
                         format::number(other.bitsAfter, 2));
    }
    ranking_->setText(bins.join(QLatin1Char('\n')));
    ranking_->setVisible(showsWorth() && !bins.isEmpty());
}

void ProbeCard::setTimeLeft(double seconds)
{
    const QString left = narrow_ ? tr("%1 left") : tr("%1 left, then refused");
    setNote(isVoid() ? tr("void")
            : asks() ? left.arg(format::countdown(seconds))
                     : QString(),
            isVoid() || seconds < 10.0 ? Tone::Bad : Tone::Accent);
}

void ProbeCard::setPreconditions(const QList<Precondition>& preconditions)
{
    const auto unmet = firstMissing(preconditions);
    const QString missing = unmet ? translated(*unmet) : QString();
    const QString how =
        !unmet ? tr("Hold the mouse button or Space for 1.5 s; releasing early has no effect")
               : tr("Cannot be approved: %1").arg(missing);
    setTip(*approve_, (how + QLatin1Char('\n') + linesOf(preconditions)).trimmed());
    if (missing == whyVoid_) return;
    whyVoid_ = missing;
    if (!asks()) return;
    showFacts();
    showApproval();
    if (isVoid()) announce(*this);
}

void ProbeCard::showApproval()
{
    const ProbePlace place = placeOf(*proposal_);
    const QString where = placeText(place), bin = binText(place);
    approve_->setEnabled(!isVoid());
    approve_->setText(isVoid() ? tr("approval void: probe %1").arg(where)
                               : tr("hold to approve probe %1 (Space)").arg(where));
    approve_->setAccessibleName(isVoid() ? tr("The probe of %1 cannot be approved").arg(bin)
                                         : tr("Hold to approve the probe of %1").arg(bin));
}

void ProbeCard::setProbing(ProbePlace place, double elapsed, double expected)
{
    proposal_.reset();
    worth_.reset();
    setAccessibleDescription(QString());
    setNote({}, Tone::Accent);
    probingText_->setText(tr("The arm is probing %1").arg(binText(place)));
    const double share =
        expected > 0.0 && std::isfinite(elapsed) ? std::clamp(elapsed / expected, 0.0, 1.0) : 0.0;
    probingBar_->setValue(static_cast<int>(share * 1000.0));
    probingBar_->setFormat(
        tr("%1 of about %2")
            .arg(format::countdown(std::floor(elapsed)), format::countdown(expected)));
    showPage(kProbing);
}

void ProbeCard::setNothing(const QString& why)
{
    proposal_.reset();
    worth_.reset();
    setAccessibleDescription(QString());
    setNote({}, Tone::Muted);
    nothing_->setText(why);
    showPage(kNothing);
}

}  // namespace terratact
