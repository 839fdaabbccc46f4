#include "widgets/control/drive_pad.h"

#include <QHBoxLayout>
#include <QRegularExpression>

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
    const auto button = [&](const QString& text, const QString& name, int direction) {
        auto* held = new HeldButton(text, this);
        held->setAccessibleName(name);
        connect(held, &HeldButton::holdBegan, this,
                [this, direction] { emit driveRequested(direction); });
        connect(held, &HeldButton::holdEnded, this, &DrivePad::haltRequested);
        row->addWidget(held, 1);
        return held;
    };
    back_ = button({}, tr("Hold to drive back"), -1);
    forward_ = button({}, tr("Hold to drive forward"), +1);
    setNarrow(false);
    setPreconditions({});
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

void DrivePad::setNarrow(bool narrow)
{
    static const QRegularExpression kHold(
        QStringLiteral("\\S+: "));  // removes "hold: ", which the tip repeats
    const auto words = [narrow](QString text) { return narrow ? text.remove(kHold) : text; };
    back_->setText(words(tr("◀ hold: back (S)")));
    forward_->setText(words(tr("hold: forward (W) ▶")));
}

void DrivePad::setProminent(bool prominent)
{
    for (HeldButton* button : {forward_, back_})
        button->setMinimumHeight(scaled(prominent ? 72 : kTarget));
}

}  // namespace terratact
