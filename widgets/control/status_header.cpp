#include "widgets/control/status_header.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/base/elided_label.h"
#include "widgets/base/spoken.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/arming_control.h"

namespace terratact {
namespace {

// [px]; the gap keeps other controls away from STOP
constexpr int kBetween = 7, kBetweenLines = 6, kBeforeStop = 12;
constexpr int kSourceCharacters = 24;  // enough characters to distinguish sources

/// Returns the minimum width [px] of the items that are not hidden.
int widthOf(const QList<QWidget*>& row)
{
    int width = 0;
    for (const QWidget* widget : row)
        if (!widget->isHidden())
            width += std::max(widget->minimumSizeHint().width(), widget->minimumWidth()) + kBetween;
    return width;
}

int heightOf(const QList<QWidget*>& row)
{
    int height = 0;
    for (const QWidget* widget : row)
        if (!widget->isHidden()) height = std::max(height, widget->sizeHint().height());
    return height;
}

int widthWith(const QPushButton& button, const QString& text)
{
    const QFontMetrics metrics = button.fontMetrics();
    return button.sizeHint().width() - metrics.horizontalAdvance(button.text())
         + metrics.horizontalAdvance(text);
}

QString stopText(StopViewState::State state)
{
    switch (state) {
    case StopViewState::State::Ready:
    case StopViewState::State::Elsewhere: return StatusHeader::tr("STOP (F12)");
    case StopViewState::State::Sent: return StatusHeader::tr("STOP SENT …");
    case StopViewState::State::NotSent: return StatusHeader::tr("STOP NOT SENT");
    case StopViewState::State::Confirmed: return StatusHeader::tr("STOPPED (F12)");
    case StopViewState::State::NoEffect: return StatusHeader::tr("STOP: no commands");
    }
    return {};
}

/// Returns the text of STOP for the screen reader and the tip.
QString stopMeaning(const StopViewState& viewState)
{
    switch (viewState.state) {
    case StopViewState::State::Ready:
        return StatusHeader::tr(
            "Halts the robot at once and latches; F12 and Pause do the same everywhere");
    case StopViewState::State::Elsewhere:
        return StatusHeader::tr("Halts the robot of the console that opened this window");
    case StopViewState::State::Sent:
        return StatusHeader::tr("STOP was sent but not confirmed by the robot; it is sent again");
    case StopViewState::State::NotSent:
        return StatusHeader::tr("STOP was not sent: %1").arg(viewState.why);
    case StopViewState::State::Confirmed:
        return StatusHeader::tr("The robot reports stopped; another press sends STOP again");
    case StopViewState::State::NoEffect:
        return StatusHeader::tr("STOP has no effect here: %1").arg(viewState.why);
    }
    return {};
}

/// Returns the role of STOP in the style sheet.
QString stopRole(StopViewState::State state)
{
    switch (state) {
    case StopViewState::State::Ready:
    case StopViewState::State::Elsewhere: return QStringLiteral("stop");
    case StopViewState::State::Sent: return QStringLiteral("stopSent");
    case StopViewState::State::NotSent: return QStringLiteral("stopNotSent");
    case StopViewState::State::Confirmed: return QStringLiteral("stopped");
    case StopViewState::State::NoEffect: return QStringLiteral("stopNone");
    }
    return {};
}

/// Sets a button's role in the style sheet.
void setRole(QPushButton& button, const QString& role)
{
    if (button.property("role").toString() == role) return;
    button.setProperty("role", role);
    button.style()->unpolish(&button);
    button.style()->polish(&button);
}

QString alarmsText(int count)
{
    return count == 0 ? StatusHeader::tr("no alarms") : StatusHeader::tr("alarms: %1").arg(count);
}

}  // namespace

StatusHeader::StatusHeader(QWidget* parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("statusHeader"));
    setAccessibleName(tr("Status"));
    source_ = new ElidedLabel(this);
    source_->setObjectName(QStringLiteral("sourceName"));
    source_->setAccessibleName(tr("Where the data come from"));
    source_->setMinCharacters(kSourceCharacters);
    const auto chip = [this](const QString& name) {
        auto* label = new ElidedLabel(this);
        label->setProperty("chip", true);
        label->setAccessibleName(name);
        return label;
    };
    link_ = chip(tr("Link"));
    robot_ = chip(tr("Activity of the robot"));
    model_ = chip(tr("Model"));
    overridden_ = chip(tr("Checks overridden"));
    overridden_->setText(tr("! CHECK OVERRIDDEN"));
    setTone(*overridden_, Tone::Warning);
    overridden_->hide();
    bus_ = new QPushButton(this);
    bus_->setFocusPolicy(Qt::TabFocus);
    bus_->hide();
    connect(bus_, &QPushButton::clicked, this, &StatusHeader::busRequested);
    arming_ = new ArmingControl(this);
    alarms_ = new QPushButton(this);
    alarms_->setProperty("role", "quiet");
    alarms_->setFocusPolicy(Qt::TabFocus);
    setTip(*alarms_, tr("Active alarms, and past alarms not yet acknowledged (F4)"));
    connect(alarms_, &QPushButton::clicked, this, &StatusHeader::alarmsRequested);
    setAlarms(0, 0);
    stop_ = new QPushButton(this);
    stop_->setFocusPolicy(Qt::TabFocus);
    stop_->setAccessibleName(tr("STOP"));
    setStop({});
    quality_ = new QPushButton(this);
    quality_->setProperty("role", "quiet");
    quality_->setFocusPolicy(Qt::TabFocus);
    quality_->setAccessibleName(tr("Quality of the estimate"));
    setTip(*quality_, tr("Accuracy of an estimate against its computing time"));
    quality_->setVisible(false);

    auto* whole = new QHBoxLayout(this);
    whole->setContentsMargins(12, 5, 10, 5);
    whole->setSpacing(kBeforeStop);
    auto* lines = new QVBoxLayout;
    lines->setSpacing(kBetweenLines);
    first_ = new QHBoxLayout;
    second_ = new QHBoxLayout;
    for (QBoxLayout* line : {first_, second_}) {
        line->setSpacing(kBetween);
        lines->addLayout(line);
    }
    whole->addLayout(lines, 1);
    whole->addWidget(stop_);
    setLines(1);
    keepRoom();
    connect(stop_, &QPushButton::pressed, this, &StatusHeader::stopPressed);
}

void StatusHeader::setSource(const QString& name)
{
    source_->setText(name);
}

void StatusHeader::setLink(const QString& text, Tone tone, const QString& details)
{
    link_->setText(text);
    if (link_->toolTip() != details) setTip(*link_, details);
    const bool wasLost = link_->property("tone").toString() == QLatin1String("bad");
    setTone(*link_, tone);
    if (wasLost != (tone == Tone::Bad)) announce(*link_);
}

void StatusHeader::setBus(const QString& text, Tone tone, const QString& details,
                          const QString& brief)
{
    const QString least = tone == Tone::Plain || brief.isEmpty() ? text : brief;
    setRole(*bus_, tone == Tone::Bad       ? QStringLiteral("alarm")
                   : tone == Tone::Warning ? QStringLiteral("caution")
                                           : QStringLiteral("quiet"));
    if (busText_ != text || busBrief_ != least || busTone_ != tone) {
        busTone_ = tone;
        busText_ = text;
        busBrief_ = least;
        bus_->setText(text);
        bus_->setAccessibleName(tr("Bus: %1").arg(text));
        fit();
    }
    const QString tip = details + QLatin1Char('\n') + tr("Details: F5");
    if (bus_->toolTip() != tip) {
        setTip(*bus_, tip);
        bus_->setAccessibleDescription(details);
    }
}

void StatusHeader::setAlarms(int unseen, int all)
{
    const QString count = alarmsText(all);
    const QString text = unseen > 0 ? QStringLiteral("▲ ") + count : count;
    if (alarms_->text() == text) return;
    alarms_->setText(text);
    alarms_->setAccessibleName(tr("%1, %2 not acknowledged").arg(count).arg(unseen));
    setRole(*alarms_, unseen > 0 ? QStringLiteral("alarm") : QStringLiteral("quiet"));
}

void StatusHeader::setRobot(const QString& text, Tone tone)
{
    robot_->setText(text);
    setTone(*robot_, tone);
}

void StatusHeader::setOverridden(const QString& what)
{
    overridden_->setVisible(!what.isEmpty());
    setTip(*overridden_, what);
}

void StatusHeader::setModel(const QString& text, Tone tone, const QString& details)
{
    model_->setText(text);
    setTip(*model_, details);
    setTone(*model_, tone);
    fit();
}

QList<QWidget*> StatusHeader::upper() const
{
    return {source_, link_, bus_, robot_};
}

QList<QWidget*> StatusHeader::lower() const
{
    return {overridden_, model_, arming_};
}

QList<QWidget*> StatusHeader::last() const
{
    QList<QWidget*> row{alarms_};
    if (quality_->parentWidget() == this) row << quality_;  // other layouts place it elsewhere
    return row;
}

void StatusHeader::setLines(int lines)
{
    if (lines == lines_) return;
    lines_ = lines;
    for (QBoxLayout* line : {first_, second_})
        while (const QLayoutItem* item = line->takeAt(0)) delete item;
    QBoxLayout* below = lines > 1 ? second_ : first_;
    const auto add = [](QBoxLayout* line, const QList<QWidget*>& row) {
        for (QWidget* widget : row) line->addWidget(widget, 0, Qt::AlignVCenter);
    };
    add(first_, upper());
    if (lines > 1) first_->addStretch(1);
    add(below, lower());
    below->addStretch(1);
    add(below, last());
    layout()->activate();
}

int StatusHeader::busWidth(const QString& text) const
{
    static const QRegularExpression kLoad(QStringLiteral("[0-9]+ %"));
    QString most = text;
    return widthWith(*bus_, most.replace(kLoad, QStringLiteral("100 %")));
}

void StatusHeader::showBus(const QString& text)
{
    bus_->setMinimumWidth(busWidth(text));
    if (bus_->text() != text) bus_->setText(text);
}

void StatusHeader::keepRoom()
{
    link_->setUsual({tr("link %1 Hz · ≤ %2").arg(QStringLiteral("20"), QStringLiteral("100 ms"))});
    robot_->setUsual({QString(14, QLatin1Char('n'))});
    int width = 0;
    using State = StopViewState::State;
    const bool takes = stopState_ != State::NoEffect;
    for (const State state : {State::Ready, State::Sent, State::NotSent, State::Confirmed})
        if (takes) width = std::max(width, widthWith(*stop_, stopText(state)));
    if (!takes) width = widthWith(*stop_, stopText(stopState_));
    stop_->setMinimumWidth(width);
    alarms_->setMinimumWidth(std::max(widthWith(*alarms_, alarmsText(0)),
                                      widthWith(*alarms_, QStringLiteral("▲ ") + alarmsText(10))));
}

int StatusHeader::oneLine() const
{
    const QMargins margins = layout()->contentsMargins();
    int width = widthOf(last() << arming_);
    width += usualUpper();
    if (!overridden_->isHidden()) width += overridden_->usualWidth() + kBetween;
    return margins.left() + margins.right() + width + stopWidth();
}

int StatusHeader::stopWidth() const
{
    return stop_->isHidden() ? 0 : widthOf({stop_}) - kBetween + kBeforeStop;
}

int StatusHeader::usualUpper() const
{
    int width = 0;
    for (const ElidedLabel* label : {source_, link_, robot_})
        if (!label->isHidden()) width += label->usualWidth() + kBetween;
    return width;
}

int StatusHeader::heightFor(int width) const
{
    const QMargins margins = layout()->contentsMargins();
    // A Bad bus is shown even without room, so its height counts.
    const int bus = busText_.isEmpty() ? 0 : bus_->sizeHint().height();
    const int above = std::max(bus, heightOf(upper())), below = heightOf(lower() + last());
    const int lines = oneLine() <= width ? std::max(above, below) : above + kBetweenLines + below;
    return margins.top() + margins.bottom() + std::max(lines, heightOf({stop_}));
}

QSize StatusHeader::minimumSizeHint() const
{
    const QMargins margins = layout()->contentsMargins();
    const int lines =
        std::max(widthOf({source_, link_, robot_}), widthOf(last() << overridden_ << arming_));
    return {margins.left() + margins.right() + lines + stopWidth(),
            QFrame::minimumSizeHint().height()};
}

void StatusHeader::fit()
{
    const int wide = oneLine();
    setLines(wide > width() ? 2 : 1);
    const QMargins margins = layout()->contentsMargins();
    int room = width() - (lines_ > 1 ? minimumSizeHint().width() : wide);
    const int above = width() - margins.left() - margins.right() - stopWidth() - usualUpper();
    const int bus = busWidth(busText_) + kBetween, brief = busWidth(busBrief_) + kBetween;
    const QString tone = model_->property("tone").toString();
    const bool trouble = tone == QLatin1String("bad");
    const int model = model_->sizeHint().width() + kBetween;
    // A model that is still loading has priority over the bus load.
    const int kept = lines_ == 1 && tone == QLatin1String("warning") ? model : 0;
    const int forBus = lines_ > 1 ? above : room - kept;
    const int spare = usualUpper() - widthOf({source_, link_, robot_});
    const bool isWanted =
        busTone_ == Tone::Bad || (busTone_ == Tone::Warning && forBus + spare >= brief);
    const bool isBus = !busText_.isEmpty() && (forBus >= std::min(bus, brief) || isWanted);
    showBus(forBus >= bus ? busText_ : busBrief_);
    bus_->setVisible(isBus);
    if (isBus && lines_ == 1) room -= bus_->minimumWidth() + kBetween;
    model_->setVisible(trouble || room >= model);
}

void StatusHeader::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    fit();
}

bool StatusHeader::event(QEvent* event)
{
    const bool handled = QFrame::event(event);
    if (event->type() == QEvent::LayoutRequest) {
        keepRoom();  // the font may have changed
        fit();
    }
    return handled;
}

void StatusHeader::setQualities(const QStringList& names, const QStringList& lines, int chosen)
{
    auto* menu = new QMenu(quality_);
    for (int k = 0; k < lines.size(); ++k) {
        QAction* action = menu->addAction(lines[k]);
        action->setCheckable(true);
        action->setChecked(k == chosen);
        connect(action, &QAction::triggered, this, [this, menu, names, k] {
            for (int i = 0; i < names.size(); ++i) menu->actions().at(i)->setChecked(i == k);
            quality_->setText(names[k]);
            emit qualityChosen(k);
        });
    }
    delete quality_->menu();
    quality_->setMenu(menu);
    quality_->setText(names.value(chosen));
    quality_->setVisible(!lines.isEmpty());
}

void StatusHeader::setStop(const StopViewState& viewState)
{
    const QString meaning = stopMeaning(viewState);
    if (stop_->toolTip() != meaning) {
        stop_->setAccessibleDescription(meaning);
        setTip(*stop_, meaning);
    }
    if (stopState_ == viewState.state && !stop_->text().isEmpty()) return;
    stopState_ = viewState.state;
    stop_->setText(stopText(viewState.state));
    setRole(*stop_, stopRole(viewState.state));
    announce(*stop_);
}

QString StatusHeader::sourceName() const
{
    return source_->text();
}

QString StatusHeader::linkText() const
{
    return link_->text();
}

}  // namespace terratact
