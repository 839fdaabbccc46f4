#include "app/console/pages/gamepad_page.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>
#include <vector>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/shell/number_box.h"
#include "app/shell/preferences/pad_text.h"
#include "app/shell/second_press.h"
#include "widgets/base/card.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr int kLearnFor = 10'000;  // [ms]

PadAction padActionAt(std::size_t i)
{
    return static_cast<PadAction>(i);
}

/// Returns " · STOP" for a control with an action.
QString ofAction(const std::optional<PadAction>& action)
{
    return action ? QStringLiteral(" · ") + shortName(*action) : QString();
}

void showText(QLabel& label, const QString& text, Tone tone)
{
    if (label.text() != text) label.setText(text);
    setTone(label, tone);
}

}  // namespace

GamepadPage::GamepadPage(PreferenceStore& store, QWidget* parent) : Page(parent), store_(store)
{
    status_ = new PlainLabel(this);
    status_->setAccessibleName(tr("Gamepad"));
    status_->setWordWrap(true);
    answer_ = new PlainLabel(this);
    answer_->setAccessibleName(tr("Assignment"));
    answer_->setWordWrap(true);
    auto* right = new QVBoxLayout;
    right->setSpacing(10);
    right->addWidget(buildArrivals());
    right->addWidget(buildDrive());
    right->addStretch(1);
    auto* left = new QVBoxLayout;
    left->addWidget(buildActions());
    left->addStretch(1);
    columns_ = new QBoxLayout(QBoxLayout::LeftToRight);
    columns_->setSpacing(10);
    columns_->addLayout(left, 1);
    columns_->addLayout(right, 1);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(12, 10, 12, 10);
    all->setSpacing(10);
    all->addWidget(status_);
    all->addLayout(columns_);
    all->addStretch(1);

    learning_.setSingleShot(true);
    learning_.setInterval(kLearnFor);
    connect(&learning_, &QTimer::timeout, this,
            [this] { endLearning(tr("Nothing was assigned: no control was moved for 10 s.")); });
    connect(&store_, &PreferenceStore::changed, this, &GamepadPage::showMapping);
    endLearning({});
    showState();
}

QWidget* GamepadPage::buildActions()
{
    auto* card = new Card(tr("Actions and their controls"), this);
    actions_ = new PadView(1, card);
    actions_->setAccessibleName(tr("Actions that work now"));
    card->body()->addWidget(actions_);
    action_ = new QComboBox(card);
    action_->setAccessibleName(tr("Action to assign"));
    action_->setMinimumHeight(kTarget);
    setTip(*action_, tr("The action that gets another control"));
    for (std::size_t i = 0; i < kPadActions; ++i) action_->addItem(QString());
    connect(action_, &QComboBox::currentIndexChanged, this, [this] {
        if (learner_ && learner_->action() != chosen()) endLearning({});
    });
    assign_ = new QPushButton(card);
    assign_->setMinimumHeight(kTarget);
    connect(assign_, &QPushButton::clicked, this, &GamepadPage::learn);
    auto* row = new QHBoxLayout;
    row->addWidget(action_, 1);
    row->addWidget(assign_);
    card->body()->addSpacing(6);
    card->body()->addLayout(row);
    card->body()->addWidget(answer_);
    return card;
}

QWidget* GamepadPage::buildArrivals()
{
    auto* card = new Card(tr("What arrives"), this);
    axes_ = new PadView(1, card);
    axes_->setAccessibleName(tr("Axes"));
    buttons_ = new PadView(2, card);
    buttons_->setAccessibleName(tr("Pressed buttons"));
    card->body()->addWidget(axes_);
    card->body()->addSpacing(6);
    card->body()->addWidget(buttons_);
    return card;
}

QWidget* GamepadPage::buildDrive()
{
    auto* card = new Card(tr("Driving"), this);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    const auto number = [&](const NumberBoxText& text, double PadSettings::*value) {
        QDoubleSpinBox* box = numberBox(card, text);
        addField(*form, text.label, box);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, value, text](double shown) {
            store_.change([&](Preferences& p) { p.pad.*value = shown * text.unit; });
        });
        return box;
    };
    deadZone_ =
        number({tr("Dead zone of the stick"), kDeadZoneRange, 0, tr("%"),
                tr("Share of the stick's way around its centre that drives nothing"), kPercent},
               &PadSettings::deadZone);
    speed_ = number({tr("Speed at full deflection"), kPadSpeedRange, 2, tr("m/s"),
                     tr("The command gate accepts at most 0.6 m/s"), 1.0},
                    &PadSettings::speedLimit);
    card->body()->addLayout(form);
    defaults_ = new QPushButton(tr("Gamepad back to the defaults"), card);
    setTip(*defaults_, tr("Resets controls, dead zone and speed"));
    auto* asks = new SecondPress(*defaults_, tr("Press again to reset the gamepad"));
    connect(asks, &SecondPress::confirmed, this,
            [this] { store_.change([](Preferences& p) { p.pad = PadSettings(); }); });
    card->body()->addWidget(defaults_);
    return card;
}

PadAction GamepadPage::chosen() const
{
    return padActionAt(static_cast<std::size_t>(std::max(0, action_->currentIndex())));
}

void GamepadPage::learn()
{
    if (learner_) return endLearning(tr("Nothing was assigned."));
    const PadAction action = chosen();
    learner_.emplace(action);
    learning_.start();
    showText(
        *answer_,
        action == PadAction::Drive
            ? tr("Push the stick that drives in the direction of forward, for at most 10 s.")
            : tr("Press the button or trigger for: %1. It waits 10 s.").arg(actionName(action)),
        Tone::Accent);
    showMapping();
}

void GamepadPage::endLearning(const QString& answer)
{
    learner_.reset();
    learning_.stop();
    showText(*answer_,
             answer.isEmpty() ? tr("On this page the gamepad moves nothing; STOP acts.") : answer,
             answer.isEmpty() ? Tone::Muted : Tone::Strong);
    showMapping();
}

void GamepadPage::assign(PadAction action, const PadControl& control)
{
    PadMapping mapping = store_.current().pad.mapping;
    const auto owner = mapping.actionOf(control);
    if (!mapping.assign(action, control))
        return endLearning(
            tr("Not assigned: “%1” is a control of STOP. Give STOP another one first.")
                .arg(controlName(control)));
    store_.change([&](Preferences& p) { p.pad.mapping = mapping; });
    const QString done = tr("“%1” is now: %2.").arg(controlName(control), actionName(action));
    endLearning(owner && *owner != action
                    ? done + QLatin1Char(' ')
                          + tr("Without a control now: %1.").arg(actionName(*owner))
                    : done);
}

void GamepadPage::poll(const GamepadState& state)
{
    state_ = state;
    intents_ = follower_.poll(state, store_.current().pad, true);
    if (!learner_) return;
    if (!state.isConnected())
        return endLearning(tr("Nothing was assigned: the gamepad is not connected any more."));
    if (const auto control = learner_->poll(state)) assign(learner_->action(), *control);
}

void GamepadPage::refresh(double /*now*/)
{
    showState();
    arrange();
}

/// Puts the columns below each other where they do not fit side by side.
void GamepadPage::arrange()
{
    const QMargins margins = layout()->contentsMargins();
    int needed = margins.left() + margins.right() + columns_->spacing();
    for (int i = 0; i < columns_->count(); ++i)
        needed += columns_->itemAt(i)->minimumSize().width();
    const int room = parentWidget() ? parentWidget()->width() : width();
    columns_->setDirection(needed > room ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void GamepadPage::hideEvent(QHideEvent* event)
{
    Page::hideEvent(event);
    follower_ = {};
    endLearning({});
}

void GamepadPage::showMapping()
{
    const PadSettings& settings = store_.current().pad;
    for (std::size_t i = 0; i < kPadActions; ++i) {
        const auto& control = settings.mapping[padActionAt(i)];
        action_->setItemText(static_cast<int>(i),
                             tr("%1: %2").arg(actionName(padActionAt(i)),
                                              control ? controlName(*control) : tr("no control")));
    }
    assign_->setText(learner_ ? tr("Cancel") : tr("Assign"));
    const QSignalBlocker quietZone(deadZone_), quietSpeed(speed_);
    deadZone_->setValue(settings.deadZone / kPercent);
    speed_->setValue(settings.speedLimit);
    showState();
}

void GamepadPage::showState()
{
    showText(*status_,
             state_.isConnected()
                 ? tr("Connected: %1").arg(format::shownName(state_.name))
                       + (state_.radio ? QLatin1Char('\n')
                                             + tr("By radio: its loss is noticed late. Connect it "
                                                  "by cable.")
                                       : QString())
             : state_.trouble.empty() ? tr("No gamepad is connected. Plug one in at any time.")
                                      : translated(state_.trouble),
             state_.isConnected() && !state_.radio ? Tone::Strong : Tone::Warning);
    assign_->setEnabled(state_.isConnected());
    setTip(*assign_, state_.isConnected() ? tr("Then move the control that shall do this")
                                          : tr("No gamepad is connected"));
    showArrivals();
}

PadLine GamepadPage::lineOf(PadAction action) const
{
    const auto& control = store_.current().pad.mapping[action];
    PadLine line{actionName(action) + QStringLiteral(": ")
                 + (control ? controlName(*control) : tr("no control"))};
    const bool isDrive = action == PadAction::Drive;
    if (isDrive ? intents_.speed != 0.0 : follower_.counts(action)) {
        line.state = PadLine::State::On;
        if (isDrive)
            line.text +=
                QStringLiteral(" · ") + tr("%1 m/s").arg(format::number(intents_.speed, 2));
    } else if (follower_.isTouched(action)) {
        line.state = PadLine::State::Waits;
        line.text += QStringLiteral(" · ") + tr("release it first");
    }
    return line;
}

void GamepadPage::showArrivals()
{
    const PadSettings& settings = store_.current().pad;
    std::vector<PadLine> actions, axes, buttons;
    actions.reserve(kPadActions);
    axes.reserve(kPadAxes);
    buttons.reserve(kPadButtons);
    for (std::size_t i = 0; i < kPadActions; ++i) actions.push_back(lineOf(padActionAt(i)));
    for (std::size_t i = 0; i < kPadAxes; ++i) {
        const auto axis = static_cast<PadAxis>(i);
        const auto asStick = settings.mapping.actionOf(PadStick{axis, 1});
        const auto action = asStick ? asStick : settings.mapping.actionOf(axis);
        axes.push_back({.text = axisName(axis) + ofAction(action),
                        .bar = PadLine::Bar{state_[axis], !suits(PadAction::Stop, axis),
                                            asStick ? settings.deadZone : 0.0}});
    }
    for (std::size_t i = 0; i < kPadButtons; ++i) {
        const auto button = static_cast<PadButton>(i);
        buttons.push_back(
            {.text = controlName(button) + ofAction(settings.mapping.actionOf(button)),
             .state = state_[button] ? PadLine::State::On : PadLine::State::Off});
    }
    actions_->setLines(std::move(actions));
    axes_->setLines(std::move(axes));
    buttons_->setLines(std::move(buttons));
}

}  // namespace terratact
