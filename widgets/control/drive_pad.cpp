#include "widgets/control/drive_pad.h"

#include <QEvent>
#include <QFontMetrics>
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
    narrow_ = narrow;
    chooseTexts();
}

QStringList DrivePad::texts(Length length) const
{
    if (length == Length::Keys) return {tr("◀ S"), tr("feel F"), tr("W ▶")};
    static const QRegularExpression kHold(
        QStringLiteral("\\S+: "));  // removes "hold: ", which the tip repeats
    QStringList words{tr("◀ hold: back (S)"), tr("hold: feel (F)"), tr("hold: forward (W) ▶")};
    if (length == Length::Short) words.replaceInStrings(kHold, {});
    return words;
}

int DrivePad::widthOf(Length length) const
{
    const QFontMetrics metrics = forward_->fontMetrics();
    const int padding = forward_->sizeHint().width() - metrics.horizontalAdvance(forward_->text());
    int width = 2 * layout()->spacing();
    for (const QString& text : texts(length)) width += metrics.horizontalAdvance(text) + padding;
    return width;
}

void DrivePad::chooseTexts()
{
    Length length = narrow_ ? Length::Short : Length::Full;
    if (length == Length::Full && widthOf(length) > width()) length = Length::Short;
    if (length == Length::Short && widthOf(length) > width()) length = Length::Keys;
    const QStringList words = texts(length);
    back_->setText(words[0]);
    feel_->setText(words[1]);
    forward_->setText(words[2]);
}

QSize DrivePad::minimumSizeHint() const
{
    const QSize least = QWidget::minimumSizeHint();
    // The present words do not count: the layout would then depend on what it was before.
    return {widthOf(narrow_ ? Length::Keys : Length::Short), least.height()};
}

void DrivePad::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    chooseTexts();
}

void DrivePad::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) chooseTexts();
}

void DrivePad::setProminent(bool prominent)
{
    for (HeldButton* button : {forward_, feel_, back_})
        button->setMinimumHeight(scaled(prominent ? 72 : kTarget));
}

}  // namespace terratact
