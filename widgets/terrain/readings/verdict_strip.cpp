#include "widgets/terrain/readings/verdict_strip.h"

#include <QApplication>
#include <QEvent>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/spoken.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/terrain/readings/two_track_text.h"

namespace terratact {
namespace {

constexpr int kBadgeFrame = 16;  // [px] between the badge's edge and its word

/// Returns a probability for a bracket: "0.29", "> 0.99".
QString shortProbability(double p)
{
    if (!format::isExtremeProbability(p)) return format::number(p, 2);
    return p > 0.5 ? QStringLiteral("> 0.99") : QStringLiteral("< 0.01");
}

QString likeliestText(const Verdict& verdict)
{
    return VerdictStrip::tr("most likely at %1 … %2 (P %3)")
        .arg(format::signedLengthNumber(binCentre(verdict.likeliest), 1),
             format::signedLength(binCentre(verdict.likeliest + 1), 1),
             shortProbability(verdict.likeliestP));
}

QString placesText(const std::vector<int>& bins)
{
    QStringList names;
    for (const int bin : bins) names << format::binName(bin);
    return names.join(QStringLiteral(", "));
}

/// Returns `text`, and the bins ahead that are bounded or not felt: "…; bounded: 0.3 m; not felt: 0.6 m".
QString withUnfelt(const QString& text, const Verdict& verdict)
{
    QStringList parts{text};
    if (!verdict.bounded.empty())
        parts << VerdictStrip::tr("bounded: %1").arg(placesText(verdict.bounded));
    if (const std::vector<int> bins = notFelt(verdict); !bins.empty())
        parts << VerdictStrip::tr("not felt: %1").arg(placesText(bins));
    return parts.join(QStringLiteral("; "));
}

/// Returns how far all ground ahead is felt.
QString feltText(const Verdict& verdict)
{
    return isNothingFeltAhead(verdict)
             ? VerdictStrip::tr("nothing ahead is felt")
             : VerdictStrip::tr("felt to %1 only").arg(format::signedLength(verdict.feltTo, 2));
}

/// Returns a short form of one reason among several, which share two lines.
QString briefly(WithholdReason reason)
{
    switch (reason) {
    case WithholdReason::Stale: return VerdictStrip::tr("no live telemetry");
    case WithholdReason::TelemetryGap: return VerdictStrip::tr("the link was lost");
    case WithholdReason::NotConverged: return VerdictStrip::tr("not converged");
    case WithholdReason::UnlikeTraining: return VerdictStrip::tr("unlike all training");
    case WithholdReason::Roll: return VerdictStrip::tr("the robot rolls");
    case WithholdReason::Asymmetry: return VerdictStrip::tr("the flippers differ");
    case WithholdReason::Differential: return VerdictStrip::tr("the differential has turned");
    case WithholdReason::SensorFault: return VerdictStrip::tr("a sensor may be wrong");
    case WithholdReason::Contradiction: return VerdictStrip::tr("it contradicts the readings");
    }
    return {};
}

/// Returns the verdict's name in the style sheet.
QString wordOf(StepVerdict answer)
{
    switch (answer) {
    case StepVerdict::Clear: return QStringLiteral("clear");
    case StepVerdict::Blocked: return QStringLiteral("blocked");
    case StepVerdict::CannotTell: return QStringLiteral("open");
    }
    return {};
}

/// Returns shortfall and remedy in few words, for the strip's two lines.
QString briefShortfall(const Verdict& verdict, bool withHelp)
{
    QString text;
    switch (verdict.shortfall) {
    case Shortfall::None: break;
    case Shortfall::NothingFelt: text = VerdictStrip::tr("flippers press on nothing"); break;
    case Shortfall::ShortHorizon: text = feltText(verdict); break;
    case Shortfall::Spanned: text = VerdictStrip::tr("not felt under the flippers"); break;
    }
    if (!withHelp) return text;
    if (verdict.help == Help::Flatten) text += VerdictStrip::tr(", flatter flippers help");
    if (verdict.help == Help::DriveOn)
        text += VerdictStrip::tr(", %1 further helps").arg(format::length(kBinWidth, 1));
    return text;
}

/// Returns how far CLEAR reaches and what lies beyond.
QString clearText(const Verdict& verdict)
{
    const QString risk = format::percent(kClearBelow);
    const QString to = format::signedLength(verdict.horizon, 2);
    const QString end = format::length(binEnd(kBins - 1), 2);
    if (!verdict.touchRecorded)
        return withUnfelt(
            VerdictStrip::tr("up to %2 ahead of the IMU, at a risk below %1 %").arg(risk, end),
            verdict);
    if (verdict.shortfall == Shortfall::Spanned)
        return withUnfelt(
            VerdictStrip::tr("%1, spanned to %2, risk below %3 %").arg(feltText(verdict), to, risk),
            verdict);
    return withUnfelt(
        VerdictStrip::tr("felt to %1 ahead of the IMU, risk below %2 %").arg(to, risk), verdict);
}

/// Returns which ground is not felt, and which action besides a probe would help.
QString shortfallText(const Verdict& verdict)
{
    QString text = withUnfelt(translated(describe(verdict.shortfall)), verdict);
    if (verdict.help != Help::Nothing)
        text = VerdictStrip::tr("%1. Helps: %2").arg(text, translated(describe(verdict.help)));
    return text;
}

/// Returns the badge's text; the horizon has its own line, so that the badge keeps its width.
QString badgeOf(const Verdict& verdict)
{
    if (!isClearToHorizon(verdict)) return VerdictStrip::answerOf(verdict);
    return VerdictStrip::tr("✔ CLEAR") + QLatin1Char('\n')
         + VerdictStrip::tr("to %1").arg(format::signedLength(verdict.horizon, 2));
}

/// Returns the badge of the robot's answer; CLEAR reaches to the nearer horizon of both sides.
QString badgeOf(const TwoTrackVerdict& verdict)
{
    const bool isLeft = verdict.side[0].horizon <= verdict.side[1].horizon;
    Verdict robot = verdict.side[isLeft ? 0 : 1];
    robot.stepVerdict = verdict.both;
    return badgeOf(robot);
}

QString withheldText(const std::vector<WithholdReason>& reasons)
{
    QStringList texts;
    for (const WithholdReason reason : reasons)
        texts << (reasons.size() > 1 ? briefly(reason) : translated(describe(reason)));
    return VerdictStrip::tr("withheld: %1").arg(texts.join(QStringLiteral(" · ")));
}

}  // namespace

VerdictStrip::VerdictStrip(QWidget* parent) : QFrame(parent)
{
    setProperty("card", true);
    badge_ = new PlainLabel(this);
    badge_->setObjectName(QStringLiteral("verdictBadge"));
    badge_->setAlignment(Qt::AlignCenter);
    badge_->setAccessibleName(tr("Verdict"));
    question_ = new PlainLabel(this);
    question_->setObjectName(QStringLiteral("verdictQuestion"));
    question_->setWordWrap(true);
    setTip(*question_,
           tr("A step: two bins at most %3 apart differ in height by more than the limit. The bins "
              "lie %1 to %2 ahead of the IMU")
               .arg(format::lengthNumber(binBegin(kFirstAhead), 2),
                    format::length(binEnd(kBins - 1), 2),
                    format::length(kStepBins * kBinWidth, 1)));
    nameQuestion(false);
    question_->installEventFilter(this);
    reason_ = new PlainLabel(this);
    reason_->setAccessibleName(tr("Why"));
    reason_->setWordWrap(true);
    setTone(*reason_, Tone::Muted);
    reason_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    const auto button = [this](const QString& text, const QString& name) {
        auto* b = new QPushButton(text, this);
        b->setFocusPolicy(Qt::TabFocus);
        b->setAccessibleName(name);
        b->setAutoRepeat(true);
        b->setProperty("role", "small");
        return b;
    };
    lower_ = button(QStringLiteral("−"), tr("Lower the limit"));
    raise_ = button(QStringLiteral("+"), tr("Raise the limit"));
    connect(lower_, &QPushButton::clicked, this, [this] { choose(limit_ - kLimitStep); });
    connect(raise_, &QPushButton::clicked, this, [this] { choose(limit_ + kLimitStep); });

    auto* words = new QVBoxLayout;
    words->setSpacing(1);
    words->addWidget(question_);
    words->addWidget(reason_);
    head_ = new QHBoxLayout;
    row_ = new QHBoxLayout(this);
    row_->setContentsMargins(8, 6, 10, 6);
    row_->setSpacing(10);
    row_->addLayout(head_);
    row_->addWidget(badge_);
    row_->addLayout(words, 1);
    row_->addWidget(lower_);
    row_->addWidget(raise_);
    setLimit(kStepLimit);
    setNothing(QString());
    resizeToFont();
}

void VerdictStrip::resizeToFont()
{
    // Always reserves two lines, because a jumping layout misleads. More lines are used only where nothing else moves.
    const int lines = (sidesWrap_ ? 1 : 2) * QFontMetrics(QApplication::font()).lineSpacing() + 2;
    reason_->setMinimumHeight(lines);
    reason_->setMaximumHeight(stacked_ ? QWIDGETSIZE_MAX : lines);
    // The badge keeps its width for every word.
    QFont bold = QApplication::font();
    bold.setPixelSize(scaled(19));  // equal to the style sheet
    bold.setBold(true);
    int width = 0;
    for (const QString& word :
         {tr("✔ CLEAR"), tr("to %1").arg(format::signedLength(binEnd(kBins - 1), 2)),
          tr("✘ BLOCKED"), tr("? CANNOT TELL"), tr("NO VERDICT")})
        width = std::max(width, QFontMetrics(bold).horizontalAdvance(word));
    badge_->setMinimumWidth(width + kBadgeFrame);
}

void VerdictStrip::setStacked(bool stacked)
{
    if (stacked == stacked_) return;
    stacked_ = stacked;
    for (QWidget* const part : std::initializer_list<QWidget*>{badge_, lower_, raise_})
        (stacked ? row_ : head_)->removeWidget(part);
    row_->setDirection(stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    QBoxLayout* const to = stacked ? head_ : row_;
    to->insertWidget(stacked ? 0 : 1, badge_, stacked ? 1 : 0);
    to->addWidget(lower_);
    to->addWidget(raise_);
    resizeToFont();
}

void VerdictStrip::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::StyleChange) resizeToFont();
}

QString VerdictStrip::answerOf(const Verdict& verdict)
{
    switch (verdict.stepVerdict) {
    case StepVerdict::Clear:
        return verdict.touchRecorded
                 ? tr("✔ CLEAR to %1").arg(format::signedLength(verdict.horizon, 2))
                 : tr("✔ CLEAR");
    case StepVerdict::Blocked: return tr("✘ BLOCKED");
    case StepVerdict::CannotTell: return tr("? CANNOT TELL");
    }
    return {};
}

QString VerdictStrip::probabilityOf(const Verdict& verdict, double limit)
{
    const StepProbability& step = answeredBy(verdict);
    const bool isExtreme = format::isExtremeProbability(step.p);
    const QString shown = format::probability(step.p, step.monteCarloSd);
    if (isClearToHorizon(verdict))
        return (isExtreme ? tr("P(step > %1 to %2): %3") : tr("P(step > %1 to %2) = %3"))
            .arg(format::length(limit, 2), format::signedLength(verdict.horizon, 2), shown);
    return (isExtreme ? tr("P(step > %1 ahead): %2") : tr("P(step > %1 ahead) = %2"))
        .arg(format::length(limit, 2), shown);
}

QString VerdictStrip::whyOf(const Verdict& verdict)
{
    switch (verdict.stepVerdict) {
    case StepVerdict::Clear: return clearText(verdict);
    case StepVerdict::Blocked: return likeliestText(verdict);
    case StepVerdict::CannotTell: break;
    }
    if (!verdict.withheldFor.empty()) return withheldText(verdict.withheldFor);
    if (verdict.shortfall != Shortfall::None) return shortfallText(verdict);
    return tr("not decided (CLEAR below %1, BLOCKED above %2); %3")
        .arg(format::number(kClearBelow, 2), format::number(kBlockedAbove, 2),
             likeliestText(verdict));
}

QString VerdictStrip::brieflyOf(const Verdict& verdict, bool isOfTwo)
{
    if (!verdict.withheldFor.empty()) return whyOf(verdict);
    if (verdict.shortfall != Shortfall::None) return briefShortfall(verdict, !isOfTwo);
    return isOfTwo ? tr("not decided") : tr("not decided; %1").arg(likeliestText(verdict));
}

bool VerdictStrip::eventFilter(QObject* object, QEvent* event)
{
    if (object == question_ && event->type() == QEvent::Resize) fitSides();
    return QFrame::eventFilter(object, event);
}

void VerdictStrip::fitSides()
{
    const auto fits = [this](const QString& line) {
        return stacked_ || line.isEmpty()
            || question_->fontMetrics().horizontalAdvance(line) <= question_->width();
    };
    const bool isShort = !fits(sides_);
    if (!sides_.isEmpty()) question_->setText(isShort ? shortSides_ : sides_);
    const bool wraps = isShort && !fits(shortSides_);  // the reason gives it one of its lines
    if (std::exchange(sidesWrap_, wraps) != wraps) resizeToFont();
}

void VerdictStrip::nameQuestion(bool isOfSides)
{
    if (!isOfSides) {
        sides_.clear();
        fitSides();
    }
    question_->setAccessibleDescription(isOfSides ? sides_ : QString());
    question_->setAccessibleName(isOfSides ? tr("Verdict of each side")
                                           : tr("Probability of a step ahead"));
}

void VerdictStrip::setVerdict(const TwoTrackVerdict& verdict, const QString& probe)
{
    if (verdict.onePlane) return setVerdict(verdict.side[0], probe);
    setTwoTracks(verdict, probe);
}

void VerdictStrip::setTwoTracks(const TwoTrackVerdict& verdict, const QString& probe)
{
    const bool withheld = isWithheld(verdict);
    const QString probability = eitherText(verdict, limit_), sides = sidesText(verdict);
    const bool ofSides = !withheld && !sides.isEmpty();
    // A withheld probability must not be the first thing that is read.
    const QString question = withheld ? QStringLiteral("(%1)").arg(probability) : probability;
    const bool isNew = std::exchange(sides_, ofSides ? sides : QString()) != sides;
    shortSides_ = sidesText(verdict, true);
    nameQuestion(ofSides);
    if (!ofSides) question_->setText(question);
    setTone(*question_, withheld ? Tone::Muted : Tone::Strong);
    setTone(*reason_, withheld ? Tone::Warning : Tone::Muted);
    QStringList parts;
    if (ofSides) parts << probability;
    if (const QString why = whyText(verdict, true); !why.isEmpty()) parts << why;
    QString text = parts.join(QStringLiteral(" · "));
    if (!probe.isEmpty() && !withheld) text += QStringLiteral(" — ") + probe;
    reason_->setText(text);
    QStringList tip{sides, probability, whyText(verdict, false), probe};
    tip.removeAll(QString());
    setTip(*reason_, tip.join(QLatin1Char('\n')));
    setAnswer(badgeOf(verdict), wordOf(verdict.both), withheld);
    fitSides();
    if (isNew && ofSides) announce(*question_);
}

void VerdictStrip::setVerdict(const Verdict& verdict, const QString& probe)
{
    nameQuestion(false);
    const bool isWithheld = !verdict.withheldFor.empty();
    const QString probability = probabilityOf(verdict, limit_);
    // A withheld probability must not be the first thing that is read.
    question_->setText(isWithheld ? QStringLiteral("(%1)").arg(probability) : probability);
    setTone(*question_, isWithheld ? Tone::Muted : Tone::Strong);
    setTone(*reason_, isWithheld ? Tone::Warning : Tone::Muted);
    const bool isBrief = verdict.stepVerdict == StepVerdict::CannotTell && !isWithheld;
    QString why = isBrief ? brieflyOf(verdict) : whyOf(verdict);
    if (!probe.isEmpty() && !isWithheld) why += QStringLiteral(" — ") + probe;
    reason_->setText(why);
    QStringList tip{why};
    if (isBrief) tip << whyOf(verdict);
    for (const WithholdReason reason : verdict.withheldFor) tip << translated(describe(reason));
    setTip(*reason_, tip.join(QLatin1Char('\n')));
    setAnswer(badgeOf(verdict), wordOf(verdict.stepVerdict), isWithheld);
}

void VerdictStrip::setNothing(const QString& why)
{
    nameQuestion(false);
    question_->setText(tr("Is there a step of more than %1 ahead?").arg(format::length(limit_, 2)));
    setTone(*question_, Tone::Strong);
    setTone(*reason_, Tone::Muted);
    reason_->setText(why);
    setTip(*reason_, QString());
    setAnswer(tr("NO VERDICT"), QStringLiteral("none"), false);
}

/// Announces changes after all labels are set.
void VerdictStrip::setAnswer(const QString& answer, const QString& stepVerdict, bool withheld)
{
    badge_->setText(answer);
    if (badge_->property("answer").toString() != stepVerdict) {
        badge_->setProperty("answer", stepVerdict);
        badge_->style()->unpolish(badge_);
        badge_->style()->polish(badge_);
        announce(*badge_);
    }
    // The same verdict may have another reason now.
    if (std::exchange(withheld_, withheld) != withheld) announce(*reason_);
}

void VerdictStrip::setLimit(double metres)
{
    limit_ = std::isfinite(metres) ? std::clamp(metres, kMinLimit, kMaxLimit) : kStepLimit;
    const bool lowest = limit_ <= kMinLimit + 1e-9, highest = limit_ >= kMaxLimit - 1e-9;
    lower_->setEnabled(!lowest);
    raise_->setEnabled(!highest);
    setTip(*lower_, lowest ? tr("%1 is the lowest limit").arg(format::length(kMinLimit, 2))
                           : tr("Lowers the step limit (PgDown)"));
    setTip(*raise_, highest ? tr("%1 is the highest limit").arg(format::length(kMaxLimit, 2))
                            : tr("Raises the step limit (PgUp)"));
}

void VerdictStrip::choose(double metres)
{
    const double rounded = std::round(metres / kLimitStep) * kLimitStep;
    if (rounded < kMinLimit - 1e-9 || rounded > kMaxLimit + 1e-9) return;
    setLimit(rounded);
    emit limitChosen(limit_);
}

QString VerdictStrip::badge() const
{
    return badge_->text();
}

QString VerdictStrip::question() const
{
    return question_->text();
}

QString VerdictStrip::reason() const
{
    return reason_->text();
}

}  // namespace terratact
