#include "widgets/control/arming_control.h"

#include <QHBoxLayout>
#include <QPushButton>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "widgets/base/held_button.h"
#include "widgets/base/palette.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

QString disarmedText()
{
    return ArmingControl::tr("DISARMED · arm (M)");
}

QString armedText()
{
    return ArmingControl::tr("ARMED · disarm (M)");
}

QString requestedText()
{
    return ArmingControl::tr("arming … cancel (M)");
}

}  // namespace

ArmingControl::ArmingControl(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Arming"));
    arm_ = new QPushButton(this);
    arm_->setProperty("role", "quiet");
    confirm_ = new HoldToConfirmButton(tr("hold to arm (M)"), &Theme::caution, this);
    confirm_->setAccessibleName(tr("Hold to arm the robot"));
    setTip(*confirm_, tr("Hold within 5 s; then commands from this console move the robot"));
    confirm_->setHoldTime(1000);
    disarm_ = new QPushButton(this);
    disarm_->setProperty("role", "armed");
    setTip(*disarm_, tr("Commands from this console move the robot. A click halts and disarms it"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (QPushButton* button : std::initializer_list<QPushButton*>{arm_, confirm_, disarm_}) {
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    }
    connect(arm_, &QPushButton::clicked, this, &ArmingControl::armingWanted);
    connect(confirm_, &HoldToConfirmButton::confirmed, this, &ArmingControl::armingConfirmed);
    connect(disarm_, &QPushButton::clicked, this, &ArmingControl::disarmed);
    setState({}, {});
}

void ArmingControl::setState(const ArmingState& state, const QList<Precondition>& preconditions)
{
    const bool off = state.phase == ArmingPhase::Disarmed;
    const bool on = state.phase == ArmingPhase::Armed;
    missing_ = firstMissing(preconditions);
    const bool possible = !missing_;
    QString tip = possible ? tr("Asks for a second action within 5 s") : tr("Not possible now:");
    if (!preconditions.isEmpty()) tip += QLatin1Char('\n') + linesOf(preconditions);
    if (off && state.cause != DisarmCause::None)
        tip += tr("\nLast disarmed: %1").arg(translated(describe(state.cause)));
    listens_ = false;
    arm_->setText(disarmedText());
    arm_->setVisible(off);
    arm_->setEnabled(possible);
    setTip(*arm_, tip);
    confirm_->setVisible(state.phase == ArmingPhase::Confirming);
    disarm_->setText(on ? armedText() : requestedText());
    disarm_->setVisible(on || state.phase == ArmingPhase::Requested);
}

void ArmingControl::setListening(const QString& why)
{
    listens_ = true;
    arm_->setText(tr("NO COMMANDS"));
    arm_->setVisible(true);
    arm_->setEnabled(false);
    setTip(*arm_, why);
    confirm_->setVisible(false);
    disarm_->setVisible(false);
}

QSize ArmingControl::sizeHint() const
{
    if (listens_) return arm_->sizeHint();
    QSize size = confirm_->sizeHint();
    const auto take = [&size](const QPushButton& button, const QString& text) {
        const QSize hint = button.sizeHint();  // ensures the style sheet's font
        const QFontMetrics metrics = button.fontMetrics();
        const int frame = hint.width() - metrics.horizontalAdvance(button.text());
        size = size.expandedTo({metrics.horizontalAdvance(text) + frame, hint.height()});
    };
    take(*arm_, disarmedText());
    for (const QString& text : {armedText(), requestedText()}) take(*disarm_, text);
    return size;
}

void ArmingControl::pressKey()
{
    constexpr qint64 kRepeat = 40;  // [ms]
    if (released_.isValid() && released_.elapsed() < kRepeat && !confirm_->isHeld()) return;
    if (confirm_->isVisible()) return confirm_->hold();
    for (QPushButton* button : {arm_, disarm_})
        if (button->isVisible() && button->isEnabled()) return button->click();
    if (arm_->isVisible() && missing_ && !listens_) emit impossible(*missing_);
}

void ArmingControl::releaseKey()
{
    confirm_->letGoSoon();
    released_.start();
}

}  // namespace terratact
