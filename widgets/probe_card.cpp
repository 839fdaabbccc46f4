#include "widgets/probe_card.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/held_button.h"
#include "widgets/look.h"
#include "widgets/palette.h"
#include "widgets/scroll_column.h"
#include "widgets/words.h"

namespace terratact {
namespace {

enum Page { kNothing, kQuestion, kProbing };
constexpr int kFacts = 6, kFactsNarrow = 4;  // lines seen in any case

QString percent(double share)
{
    return words::number(-100.0 * share, 0);
}

}  // namespace

ProbeCard::ProbeCard(QWidget* parent) : Card(tr("Arm probe"), parent)
{
    pages_ = new QStackedLayout;
    body()->addLayout(pages_, 1);

    nothing_ = new QLabel(this);
    nothing_->setWordWrap(true);
    nothing_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setTone(*nothing_, Tone::Muted);
    pages_->addWidget(nothing_);

    asking_ = questionPage();
    pages_->addWidget(asking_);
    pages_->addWidget(probingPage());
    connect(approve_, &HoldToConfirmButton::confirmed, this, [this] {
        if (asks()) emit approved(proposal_->id);
    });
    connect(refuse_, &QPushButton::clicked, this, [this] {
        if (asks()) emit refused(proposal_->id);
    });
    setNarrow(false);
    setNothing(QString());
}

QLabel* ProbeCard::fact(QGridLayout& rows, const QString& name, Tone tone)
{
    auto* key = new QLabel(name, this);
    setTone(*key, Tone::Muted);
    key->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* value = new QLabel(this);
    setTone(*value, tone);
    value->setAccessibleName(name);
    value->setWordWrap(true);
    keys_ << key;
    const int at = rows.rowCount();
    rows.addWidget(key, at, 0);
    rows.addWidget(value, at, 1);
    return value;
}

QWidget* ProbeCard::questionPage()
{
    auto* question = new QWidget(this);
    facts_ = new ScrollColumn(kFacts, question);
    facts_->setAccessibleName(tr("What the probe is expected to buy"));
    auto* rows = new QGridLayout;
    rows->setHorizontalSpacing(14);
    rows->setVerticalSpacing(1);
    rows->setColumnStretch(1, 1);
    where_ = fact(*rows, tr("where"), Tone::Accent);
    predicted_ = fact(*rows, tr("predicted"), Tone::Strong);
    band_ = fact(*rows, tr("80 % band"), Tone::Strong);
    variance_ = fact(*rows, tr("all bins"), Tone::Strong);
    cost_ = fact(*rows, tr("costs"), Tone::Strong);
    question_ = fact(*rows, tr("step ahead"), Tone::Strong);
    questionKey_ = keys_.last();
    facts_->column()->addLayout(rows);
    // Room to spare goes between the lines: what is to be decided is read at a glance.
    for (int line = 1; line < rows->rowCount(); ++line) rows->setRowStretch(line, 1);
    facts_->column()->addStretch(1);

    auto* instead = new QHBoxLayout;
    instead->setSpacing(6);
    for (std::size_t i = 0; i < kOthers; ++i) {
        others_[i] = new QPushButton(question);
        others_[i]->setFocusPolicy(Qt::TabFocus);
        others_[i]->setProperty("role", "compact");
        instead->addWidget(others_[i], 1);
        connect(others_[i], &QPushButton::clicked, this, [this, i] {
            if (asks() && i < proposal_->others.size())
                emit otherChosen(proposal_->id, proposal_->others[i].bin);
        });
    }
    approve_ = new HoldToConfirmButton(QString(), &Theme::decide, question);
    setPreconditions({});
    refuse_ = new QPushButton(question);
    refuse_->setFocusPolicy(Qt::TabFocus);
    refuse_->setToolTip(tr("Refuses the arm; as good an answer as any other"));
    auto* column = new QVBoxLayout(question);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(facts_, 1);
    column->addLayout(instead);
    column->addWidget(approve_);
    column->addWidget(refuse_);
    return question;
}

QWidget* ProbeCard::probingPage()
{
    auto* probing = new QWidget(this);
    auto* column = new QVBoxLayout(probing);
    column->setContentsMargins(0, 0, 0, 0);
    probingText_ = new QLabel(probing);
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
    facts_->setLeastLines(narrow ? kFactsNarrow : kFacts);
    for (QLabel* label : {where_, band_}) label->setVisible(!narrow);
    for (QLabel* key : std::as_const(keys_)) key->setVisible(!narrow);
    refuse_->setText(narrow ? tr("Do not probe (N)")
                            : tr("Do not probe: 0 s, the estimate stays (N)"));
    if (proposal_) showWorth();
}

int ProbeCard::leastHeight() const
{
    return frameHeight() + asking_->layout()->totalMinimumSize().height();
}

void ProbeCard::showPage(int page)
{
    for (int i = 0; i < pages_->count(); ++i) {  // the others need no room
        const auto policy = i == page ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        pages_->widget(i)->setSizePolicy(policy, policy);
    }
    pages_->setCurrentIndex(page);
}

bool ProbeCard::asks() const
{
    return proposal_.has_value();
}

std::optional<quint64> ProbeCard::shown() const
{
    if (!proposal_ || painted_ != proposal_->id) return std::nullopt;
    if (!isVisible() || window()->isMinimized()) return std::nullopt;
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
    approve_->letGo();  // a hold begun on another question does not count for this one
    proposal_ = proposal;
    where_->setText(tr("bin %1").arg(words::binName(proposal.bin)));
    band_->setText(
        tr("%1 … %2 m")
            .arg(words::signedNumber(proposal.q10, 2), words::signedNumber(proposal.q90, 2)));
    showWorth();
    approve_->setText(tr("hold to approve probe at %1 (Space)").arg(words::binName(proposal.bin)));
    approve_->setAccessibleName(
        tr("Hold to approve the probe of bin %1").arg(words::binName(proposal.bin)));
    showPage(kQuestion);
    update();  // all of it
}

void ProbeCard::showWorth()
{
    const ProbeProposal& p = *proposal_;
    const QString height = words::signedNumber(p.height, 2), sd = words::number(p.sd, 2);
    predicted_->setText(narrow_ ? tr("predicted %1 ± %2 m").arg(height, sd)
                                : tr("%1 m ± %2 m (sd)").arg(height, sd));
    questionKey_->setText(tr("step > %1 m").arg(words::number(p.stepLimit, 2)));
    cost_->setText(tr("≈ %1 s, arm out in smoke").arg(words::number(p.seconds, 0)));
    if (p.worth) {
        const double bits = p.bitsBefore - p.worth->bitsAfter;
        variance_->setText(tr("total variance %1 %").arg(percent(p.worth->varianceShare)));
        const QString before = words::number(p.bitsBefore, 2);
        const QString after = words::number(p.worth->bitsAfter, 2);
        question_->setText(
            narrow_ ? tr("step ahead: %1 → %2 bit").arg(before, after)
                    : tr("%1 → %2 bit: %3 a minute")
                          .arg(before, after, words::number(60.0 * bits / p.seconds, 2)));
    } else {
        variance_->setText(tr("this bin to ± %1 m").arg(words::number(p.armSd, 2)));
        question_->setText(narrow_ ? tr("step ahead: not known for this method")
                                   : tr("not known for this method"));
    }
    showOthers();
}

void ProbeCard::showOthers()
{
    const std::vector<ProbeWorth> offered =
        proposal_ ? proposal_->others : std::vector<ProbeWorth>();
    for (std::size_t i = 0; i < kOthers; ++i) {
        others_[i]->setVisible(i < offered.size());
        if (i >= offered.size()) continue;
        const ProbeWorth& other = offered[i];
        const QString bin = words::binName(other.bin);
        others_[i]->setText(
            narrow_ ? QStringLiteral("%1: %2").arg(i + 1).arg(bin)
                    : tr("%1: %2, %3 %").arg(i + 1).arg(bin, percent(other.varianceShare)));
        const QString all =
            tr("Ask for bin %1 instead: total variance %2 %, step ahead to %3 bit")
                .arg(bin, percent(other.varianceShare), words::number(other.bitsAfter, 2));
        others_[i]->setToolTip(all);
        others_[i]->setAccessibleName(all);
    }
}

void ProbeCard::setTimeLeft(double seconds)
{
    const QString left = narrow_ ? tr("%1 left") : tr("%1 left, then no");
    note()->setText(asks() ? left.arg(words::countdown(seconds)) : QString());
    setTone(*note(), seconds < 10.0 ? Tone::Bad : Tone::Accent);
}

void ProbeCard::setPreconditions(const QList<Precondition>& preconditions)
{
    const QString how =
        tr("Hold the mouse button or Space for 1.5 s; letting go early means nothing");
    approve_->setToolTip((how + QLatin1Char('\n') + linesOf(preconditions)).trimmed());
}

void ProbeCard::setProbing(int bin, double elapsed, double expected)
{
    proposal_.reset();
    note()->clear();
    probingText_->setText(tr("The arm is probing bin %1").arg(words::binName(bin)));
    const double share =
        expected > 0.0 && std::isfinite(elapsed) ? std::clamp(elapsed / expected, 0.0, 1.0) : 0.0;
    probingBar_->setValue(static_cast<int>(share * 1000.0));
    probingBar_->setFormat(
        tr("%1 of about %2")
            .arg(words::countdown(std::floor(elapsed)), words::countdown(expected)));
    showPage(kProbing);
}

void ProbeCard::setNothing(const QString& why)
{
    proposal_.reset();
    note()->clear();
    nothing_->setText(why);
    showPage(kNothing);
}

}  // namespace terratact
