#include "widgets/control/drive_pad.h"

#include <QHBoxLayout>
#include <QRegularExpression>
#include <algorithm>

#include "widgets/base/held_button.h"
#include "widgets/base/palette.h"
#include "widgets/base/tips.h"

namespace terratact {

DrivePad::DrivePad(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Drive"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    const auto added = [&](const QString& name) {
        auto* held = new HeldButton({}, this);
        held->setAccessibleName(name);
        row->addWidget(held, 1);
        return held;
    };
    const auto button = [&](const QString& name, int direction) {
        HeldButton* held = added(name);
        connect(held, &HeldButton::holdBegan, this,
                [this, direction] { emit driveRequested(direction); });
        connect(held, &HeldButton::holdEnded, this, &DrivePad::haltRequested);
        return held;
    };
    back_ = button(tr("Hold to drive back"), -1);
    feel_ = added(tr("Hold to feel forward"));
    connect(feel_, &HeldButton::holdBegan, this, &DrivePad::feelForwardRequested);
    connect(feel_, &HeldButton::holdEnded, this, &DrivePad::letGo);
    forward_ = button(tr("Hold to drive forward"), +1);
    setNarrow(false);
    setPreconditions({});
    setFeelPreconditions({}, false);
}

void DrivePad::setPreconditions(const QList<Precondition>& preconditions)
{
    const QString tip = tr("Dead-man key: drives while held; also the arrow keys Up and Down")
                      + QLatin1Char('\n') + linesOf(preconditions);
    for (HeldButton* button : {forward_, back_}) {
        button->setEnabled(!firstMissing(preconditions));
        setTip(*button, tip.trimmed());
    }
}

void DrivePad::setFeelPreconditions(const QList<Precondition>& preconditions, bool feels)
{
    const bool met = std::ranges::all_of(preconditions, [](const Precondition& need) {
        return need.level != Precondition::Level::Missing
            && need.level != Precondition::Level::Doubtful;
    });
    feel_->setEnabled(feels || met);
    const QString tip = tr("Dead-man key: while held, the robot presses, estimates and advances, "
                           "as long as the verdict is CLEAR")
                      + QLatin1Char('\n') + linesOf(preconditions);
    setTip(*feel_, tip.trimmed());
}

void DrivePad::setNarrow(bool narrow)
{
    static const QRegularExpression kHold(
        QStringLiteral("\\S+: "));  // removes "hold: ", which the tip repeats
    const auto words = [narrow](QString text) { return narrow ? text.remove(kHold) : text; };
    back_->setText(words(tr("◀ hold: back (S)")));
    feel_->setText(words(tr("hold: feel (F)")));
    forward_->setText(words(tr("hold: forward (W) ▶")));
}

void DrivePad::setProminent(bool prominent)
{
    for (HeldButton* button : {forward_, feel_, back_})
        button->setMinimumHeight(scaled(prominent ? 72 : kTarget));
}

}  // namespace terratact
