#include "widgets/control/atem_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/display/place_text.h"
#include "app/display/translated.h"
#include "core/atem/following.h"
#include "widgets/base/held_button.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/scroll_column.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/precondition_grid.h"

namespace terratact {
namespace {

constexpr int kLines = 3, kLinesBusy = 2;  // visible lines of the precondition list, idle and busy

Tone toneOf(AtemPhase phase)
{
    switch (phase) {
    case AtemPhase::Idle: return Tone::Strong;
    case AtemPhase::Halting:
    case AtemPhase::Pressing:
    case AtemPhase::Estimating:
    case AtemPhase::Probing:
    case AtemPhase::EstimatingAgain:
    case AtemPhase::Advancing:
    case AtemPhase::ProposingProbe: return Tone::Accent;
    case AtemPhase::Presenting: return Tone::Good;
    case AtemPhase::Stopped:
    case AtemPhase::Failed: return Tone::Bad;
    }
    return Tone::Plain;
}

QString capital(QString text)
{
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

constexpr SourceText kAlreadyExploring =
    TR_NOOP("terratact::AtemPanel", "An exploration is running: end it with Esc first");

std::size_t indexOf(Commanded command)
{
    return static_cast<std::size_t>(command);
}

QString nameOf(Commanded command)
{
    switch (command) {
    case Commanded::Explore: return AtemPanel::tr("exploring");
    case Commanded::Drive: return AtemPanel::tr("driving");
    case Commanded::Arm: return AtemPanel::tr("arming");
    case Commanded::Probe: return AtemPanel::tr("approving a probe");
    case Commanded::ReleaseStop: return AtemPanel::tr("releasing STOP");
    }
    return {};
}

}  // namespace

AtemPanel::AtemPanel(QWidget* parent) : Card(tr("Exploration (ATEM)"), parent)
{
    stateText_ = new PlainLabel(this);
    stateText_->setWordWrap(true);
    stateText_->setAccessibleName(tr("State of the exploration"));
    timeText_ = note();
    subject_ = new PlainLabel(this);
    subject_->setWordWrap(true);
    setTone(*subject_, Tone::Muted);
    needsButton_ = new QPushButton(tr("needs (P)"), this);
    needsButton_->setFocusPolicy(Qt::TabFocus);
    needsButton_->setProperty("role", "flat");
    needsButton_->setAccessibleName(tr("Requirements of a command"));
    setTip(*needsButton_, tr("Requirements of each command, and which are missing (P)"));
    auto* menu = new QMenu(needsButton_);
    needsButton_->setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, &AtemPanel::offerCommands);
    titleRow()->addWidget(needsButton_);
    list_ = new PreconditionGrid;

    request_ = new QPushButton(tr("Explore the terrain (A)"), this);
    request_->setProperty("role", "primary");
    request_->setFocusPolicy(Qt::TabFocus);
    abort_ = new QPushButton(tr("Abort (Esc)"), this);
    abort_->setFocusPolicy(Qt::TabFocus);
    ask_ = new QPushButton(this);
    ask_->setFocusPolicy(Qt::TabFocus);
    ask_->hide();
    release_ = new HoldToConfirmButton(tr("hold to release STOP (R)"), &Theme::caution, this);
    release_->setAccessibleName(tr("Hold to release STOP"));
    setTip(*release_, tr("Allows commands again; the robot does not move by itself"));

    override_ = new QPushButton(tr("Override (O)"), this);
    override_->setFocusPolicy(Qt::TabFocus);
    setTip(
        *override_,
        tr("Explores in spite of the doubtful requirement. The override is recorded and stays on "
           "the screen"));
    connect(override_, &QPushButton::clicked, this, &AtemPanel::overrideWanted);
    texts_ = new ScrollColumn(kLines, this);
    texts_->setAccessibleName(tr("Exploration (ATEM)"));
    texts_->column()->addWidget(stateText_);
    texts_->column()->addWidget(subject_);
    texts_->column()->addLayout(list_);
    texts_->column()->addStretch(1);
    others_ = new QHBoxLayout;
    others_->setSpacing(8);
    for (QPushButton* button :
         std::initializer_list<QPushButton*>{override_, abort_, ask_, release_})
        others_->addWidget(button, 1);
    buttons_ = new QHBoxLayout;
    buttons_->setSpacing(8);
    buttons_->addWidget(request_, 1);
    buttons_->addLayout(others_, 1);
    parts_ = new QVBoxLayout;
    parts_->setSpacing(kSpacing);
    parts_->addWidget(texts_, 1);
    parts_->addLayout(buttons_);
    body()->addLayout(parts_, 1);

    connect(request_, &QPushButton::clicked, this, &AtemPanel::requested);
    connect(abort_, &QPushButton::clicked, this, [this] {
        if (forgets())
            emit forgetWanted();
        else
            emit aborted();
    });
    connect(ask_, &QPushButton::clicked, this, [this] {
        if (probe_ && probe_->place) emit probeWanted(*probe_->place);
    });
    connect(release_, &HoldToConfirmButton::confirmed, this, &AtemPanel::stopReleased);
    setState({}, std::nullopt);
    setPreconditions({});
}

void AtemPanel::setState(const AtemState& state, const std::optional<PhaseTime>& time,
                         const QString& said)
{
    if (state.phase != state_.phase) lookedUp_.reset();
    state_ = state;
    said_ = said;
    showState();
    timeText_->setText(time ? timeText(*time) : QString());
    setTone(*timeText_, Tone::Strong);
    arrange();
    showList();
    showButtons();
}

void AtemPanel::showState()
{
    const auto is = [this](AtemPhase phase) { return state_.phase == phase; };
    QString text = translated(state_.followed ? describeFollowed(state_.phase)
                                              : terratact::describe(state_.phase));
    if (is(AtemPhase::Failed))
        text += QStringLiteral(": ")
              + (said_.isEmpty() ? translated(terratact::describe(state_.failure)) : said_);
    else if (!said_.isEmpty())
        text = said_;
    else if (is(AtemPhase::Idle) && !state_.followed)
        text = idleText(text);
    if (is(AtemPhase::Presenting) && state_.approvalExpired)
        text += tr("; no answer in time counts as refused");
    else if (is(AtemPhase::Presenting) && state_.probed)
        text += tr(", arm included");
    stateText_->setText(capital(text));
    setTone(*stateText_, toneOf(state_.phase));
}

/// Returns "ready" only if no listed precondition contradicts it.
QString AtemPanel::idleText(const QString& ready) const
{
    if (onlyShows_) return tr("nothing is explored");
    switch (worstOf(needs_[indexOf(Commanded::Explore)])) {
    case Precondition::Level::Missing: return tr("not ready");
    case Precondition::Level::Doubtful: return tr("not ready: doubtful");
    case Precondition::Level::Overridden:
    case Precondition::Level::Met: break;
    }
    return ready;
}

QString AtemPanel::timeText(const PhaseTime& time)
{
    const QString seconds = format::countdown(time.seconds);
    switch (time.kind) {
    case PhaseTime::Kind::Answer: return tr("%1 left").arg(seconds);
    case PhaseTime::Kind::Expected: return tr("about %1 left").arg(seconds);
    case PhaseTime::Kind::GivesUp: return tr("gives up in %1").arg(seconds);
    }
    return {};
}

void AtemPanel::setPreconditions(const QList<Precondition>& preconditions)
{
    setNeeds(Commanded::Explore, preconditions);
}

void AtemPanel::setNeeds(Commanded command, const QList<Precondition>& preconditions)
{
    needs_[indexOf(command)] = preconditions;
    if (command == Commanded::ReleaseStop)
        setTip(*release_, tr("Allows commands again; the robot does not move by itself")
                              + QLatin1Char('\n') + linesOf(preconditions));
    if (command == listed()) showList();
    if (command != Commanded::Explore) return;
    showState();
    showButtons();
}

Commanded AtemPanel::next() const
{
    if (state_.followed || onlyShows_) return Commanded::Explore;
    if (state_.phase == AtemPhase::Stopped) return Commanded::ReleaseStop;
    if (state_.phase == AtemPhase::ProposingProbe) return Commanded::Probe;
    return Commanded::Explore;
}

Commanded AtemPanel::listed() const
{
    return lookedUp_.value_or(next());
}

void AtemPanel::lookUp(std::optional<Commanded> command)
{
    lookedUp_ = command;
    showList();
}

void AtemPanel::lookUpNext()
{
    if (onlyShows_) return;
    std::size_t at = indexOf(listed());
    do {
        at = (at + 1) % kCommanded.size();
    } while (needs_[at].isEmpty() && kCommanded[at] != next());
    lookUp(kCommanded[at] == next() ? std::nullopt : std::optional(kCommanded[at]));
}

void AtemPanel::offerCommands()
{
    QMenu& menu = *needsButton_->menu();
    menu.clear();
    for (const Commanded command : kCommanded) {
        const QList<Precondition> needs = needsNow(command);
        if (needs.isEmpty()) continue;
        const QString line = markOf(worstOf(needs)) + QLatin1Char(' ') + nameOf(command);
        connect(menu.addAction(line), &QAction::triggered, this,
                [this, command] { lookUp(command); });
    }
}

/// Returns the preconditions that were set, preceded by those of this panel.
QList<Precondition> AtemPanel::needsNow(Commanded command) const
{
    QList<Precondition> needs = needs_[indexOf(command)];
    if (command == Commanded::Explore && exploring(state_.phase) && !state_.followed)
        needs.prepend({Precondition::Level::Missing, kAlreadyExploring});
    return needs;
}

/// Returns the preconditions to list. While an exploration runs, and on a narrow panel, met ones are hidden unless the
/// operator looks them up.
QList<Precondition> AtemPanel::listOf(Commanded command) const
{
    if (lookedUp_) return needsNow(command);
    QList<Precondition> list = needs_[indexOf(command)];
    if (exploring(state_.phase) || narrow_)
        list.removeIf([](const Precondition& p) { return p.level == Precondition::Level::Met; });
    return list;
}

void AtemPanel::setHasResult(bool hasResult)
{
    if (std::exchange(hasResult_, hasResult) != hasResult) showButtons();
}

void AtemPanel::setProbeToAsk(const std::optional<ProbeToAsk>& probe)
{
    if (probe == probe_) return;
    probe_ = probe;
    showButtons();
}

/// Returns true if the button clears the screen instead of ending a robot action.
bool AtemPanel::forgets() const
{
    return !exploring(state_.phase);
}

void AtemPanel::showList()
{
    const QList<Precondition> preconditions = listOf(listed());
    const bool named = listed() != Commanded::Explore || lookedUp_;
    subject_->setVisible(named && !preconditions.isEmpty());
    subject_->setText(tr("%1 needs:").arg(capital(nameOf(listed()))));
    list_->setPreconditions(preconditions);
}

void AtemPanel::forbidCommands()
{
    onlyShows_ = true;
    showState();
    arrange();
    showButtons();
}

void AtemPanel::setNarrow(bool narrow)
{
    narrow_ = narrow;
    setTitle(narrow ? tr("Exploration") : tr("Exploration (ATEM)"));
    request_->setText(narrow ? tr("Explore (A)") : tr("Explore the terrain (A)"));
    showList();
    arrange();
    showButtons();
}

void AtemPanel::arrange()
{
    const bool busy = exploring(state_.phase);
    const bool brief = narrow_ && busy && !onlyShows_;
    setTitleShown(!brief);
    // The button is higher than the title beside it and takes the margin around it. While the robot works, the time
    // stands there instead.
    const bool idle = !busy || state_.phase == AtemPhase::ProposingProbe;
    const bool button = idle && !brief && !onlyShows_;
    needsButton_->setVisible(button);
    QMargins margins = kMargins;
    if (button) margins.setTop(1);
    body()->setContentsMargins(margins);
    const int spacing = button ? 0 : kSpacing;
    if (body()->spacing() != spacing)
        body()->setSpacing(spacing);  // setSpacing() lays out again even if the value is unchanged
    parts_->setDirection(brief ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    texts_->setLeastLines(busy ? kLinesBusy : kLines);
}

int AtemPanel::leastHeight() const
{
    const int lines = kLinesBusy * (fontMetrics().lineSpacing() + texts_->column()->spacing()) + 4;
    const int button = abort_->sizeHint().height();
    if (narrow_) return kMargins.top() + kMargins.bottom() + kSpacing + std::max(lines, button);
    return frameHeight() + lines + parts_->spacing() + button;
}

/// Puts the buttons side by side if their words fit.
void AtemPanel::placeButtons()
{
    const QMargins margins = body()->contentsMargins();
    const int room = width() - margins.left() - margins.right();
    const auto place = [room](QBoxLayout& row, std::initializer_list<const QPushButton*> buttons,
                              bool stacks) {
        int needed = -row.spacing();
        for (const QPushButton* button : buttons)
            if (!button->isHidden()) needed += button->sizeHint().width() + row.spacing();
        row.setDirection(stacks || needed > room ? QBoxLayout::TopToBottom
                                                 : QBoxLayout::LeftToRight);
    };
    place(*others_, {override_, abort_, ask_, release_}, false);
    place(*buttons_, {request_, override_, abort_, ask_}, stacks_);
}

void AtemPanel::resizeEvent(QResizeEvent* event)
{
    Card::resizeEvent(event);
    placeButtons();
}

void AtemPanel::showButtons()
{
    if (onlyShows_) {
        for (QPushButton* const button :
             std::initializer_list<QPushButton*>{request_, override_, abort_, ask_, release_}) {
            button->setEnabled(false);
            button->hide();
        }
        return;
    }
    const QList<Precondition>& needs = needs_[indexOf(Commanded::Explore)];
    const Precondition::Level worst = worstOf(needs);
    const bool isMissing = worst == Precondition::Level::Missing;
    const bool isDoubtful = worst == Precondition::Level::Doubtful;
    const bool busy = exploring(state_.phase);
    const bool stopped = state_.phase == AtemPhase::Stopped && !state_.followed;
    const bool ended = state_.phase == AtemPhase::Failed || state_.phase == AtemPhase::Presenting
                    || (!busy && hasResult_);

    request_->setEnabled(!busy && !stopped && !isMissing && !isDoubtful);
    QString whyNot;
    if (busy && !state_.followed)
        whyNot = translated(kAlreadyExploring);
    else if (isMissing)
        whyNot = tr("Not possible now:");
    else if (isDoubtful)
        whyNot = tr("Doubtful, override it first (O):");
    const QString what =
        tr("Halts the robot, presses the front flippers down and estimates the terrain");
    setTip(*request_, (whyNot.isEmpty() ? what : whyNot) + QLatin1Char('\n') + linesOf(needs));
    // A hidden or disabled button passes its focus on, so this comes before others can be pressed.
    const bool asks = probe_ && !busy;
    const bool probes = asks && probe_->place && request_->isEnabled();
    abort_->setVisible(!stopped && !probes);
    ask_->setVisible(asks);
    if (asks) showProbe(probes, whyNot + QLatin1Char('\n') + linesOf(needs));
    release_->setVisible(stopped);
    const bool overrides = !busy && !stopped && isDoubtful;
    override_->setVisible(overrides);
    // A narrow panel gives the room of this button to others. kLines of its texts stay visible.
    request_->setVisible(!stopped && !(narrow_ && (busy || overrides)));
    stacks_ = overrides;
    const bool clears =
        ended || state_.followed;  // a followed exploration cannot be ended from here
    abort_->setEnabled(busy || ended);
    abort_->setText(clears ? tr("Forget (Del)") : tr("Abort (Esc)"));
    setTip(*abort_, !abort_->isEnabled() ? tr("No exploration is running")
                    : clears             ? tr("Hides the result; Ctrl+Z restores it")
                                         : tr("Halts the robot and ends the exploration"));
    placeButtons();
}

/// Shows the button of probe_. whyNot: why request_ cannot be pressed.
void AtemPanel::showProbe(bool possible, const QString& whyNot)
{
    ask_->setEnabled(possible);
    ask_->setText(possible ? tr("Probe %1 (B)").arg(sidePlace(*probe_->place)) : tr("Probe (B)"));
    QString tip;
    if (possible)
        tip = tr("The robot presses again, then the probe is proposed. The arm moves only after "
                 "your approval");
    else if (probe_->place)
        tip = whyNot;
    setTip(*ask_, (tip + QLatin1Char('\n') + probe_->text).trimmed());
}

}  // namespace terratact
