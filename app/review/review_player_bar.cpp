#include "app/review/review_player_bar.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "app/review/export/review_difference.h"
#include "app/review/review_timeline.h"
#include "app/shell/key_table.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr double kSecond = 1.0;  // [s] length of a small jump

}  // namespace

ReviewPlayerBar::ReviewPlayerBar(const SessionReader& session, ReviewMoments& moments,
                                 QWidget* parent)
    : QWidget(parent), session_(session), moments_(moments)
{
    timeline_ = new SessionTimeline(this);
    connect(timeline_, &SessionTimeline::seekWanted, this, &ReviewPlayerBar::goTo);
    difference_ = new PlainLabel(this);
    difference_->setAccessibleName(tr("From A to B"));
    difference_->setVisible(false);
    row_ = new QHBoxLayout;
    row_->setSpacing(4);
    addMoves(*row_);
    row_->addSpacing(6);
    addSpeed(*row_);
    row_->addSpacing(6);
    addCursors(*row_);
    row_->addSpacing(6);
    addPosition(*row_);
    row_->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 0, 12, 8);
    column->setSpacing(4);
    column->addWidget(difference_);
    column->addWidget(timeline_);
    column->addLayout(row_);
    player_.setRange(secondsOf(session_.begin()), secondsOf(session_.end()));
    player_.seek(player_.begin());
    resizeToFont();
    showPlayer();
}

QPushButton* ReviewPlayerBar::button(QHBoxLayout& row, const QString& text, const QString& name,
                                     const QString& tip, std::function<void()> clicked)
{
    auto* made = new QPushButton(text, this);
    made->setProperty("role", "compact");
    made->setFocusPolicy(Qt::TabFocus);
    made->setAccessibleName(name);
    setTip(*made, tip);
    connect(made, &QPushButton::clicked, this, std::move(clicked));
    row.addWidget(made);
    return made;
}

void ReviewPlayerBar::resizeToFont()
{
    constexpr int kNarrow = 38;  // [px] width of a button with a symbol; large fonts leave no more
    for (QPushButton* const made : findChildren<QPushButton*>()) {
        made->setMinimumHeight(scaled(kTarget));
        if (made != loop_ && made != follow_) made->setMinimumWidth(std::max(kNarrow, scaled(30)));
    }
    speed_->setMinimumWidth(scaled(48));
    position_->setFixedWidth(scaled(118));
    position_->setMinimumHeight(scaled(kTarget));
    showClock();
}

void ReviewPlayerBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange && of_) resizeToFont();
}

void ReviewPlayerBar::addMoves(QHBoxLayout& row)
{
    button(row, QStringLiteral("|◀"), tr("To the beginning"), tr("To the beginning (Home)"),
           [this] { goTo(player_.begin()); });
    button(row, QStringLiteral("◀·"), tr("Previous frame"), tr("Previous frame (,)"),
           [this] { stepFrame(true); });
    back_ = button(row, QStringLiteral("◀"), tr("Play backwards"), tr("Play backwards (J)"),
                   [this] { play(true); });
    play_ = button(row, QStringLiteral("▶"), tr("Play"), tr("Play, pause (Space)"), [this] {
        if (player_.playing())
            pause();
        else
            play(false);
    });
    button(row, QStringLiteral("·▶"), tr("Next frame"), tr("Next frame (.)"),
           [this] { stepFrame(false); });
    button(row, QStringLiteral("▶|"), tr("To the end"), tr("To the end (End)"),
           [this] { goTo(player_.end()); });
}

void ReviewPlayerBar::addSpeed(QHBoxLayout& row)
{
    button(row, QStringLiteral("−"), tr("Slower"), tr("Half as fast (H)"),
           [this] { speedUp(0.5); });
    speed_ = new PlainLabel(this);
    speed_->setAccessibleName(tr("Speed"));
    speed_->setAlignment(Qt::AlignCenter);
    row.addWidget(speed_);
    button(row, QStringLiteral("+"), tr("Faster"), tr("Twice as fast (F)"),
           [this] { speedUp(2.0); });
}

void ReviewPlayerBar::addCursors(QHBoxLayout& row)
{
    button(row, QStringLiteral("A"), tr("Cursor A here"), tr("Cursor A here (A); again removes it"),
           [this] { setCursor(true); });
    button(row, QStringLiteral("B"), tr("Cursor B here"), tr("Cursor B here (B); again removes it"),
           [this] { setCursor(false); });
    loop_ = button(row, tr("loop"), tr("Loop between A and B"),
                   tr("Play from A to B again and again (P)"), [this] {
                       player_.setLoop(!player_.loopWanted());
                       showPlayer();
                   });
    loop_->setCheckable(true);
    follow_ = button(row, tr("follow"), tr("Follow the end"),
                     tr("Stay at the end of a session that is still recorded (T)"), [this] {
                         player_.setFollowing(!player_.following());
                         if (player_.following()) goTo(player_.end());
                         showPlayer();
                     });
    follow_->setCheckable(true);
}

void ReviewPlayerBar::addPosition(QHBoxLayout& row)
{
    position_ = new QLineEdit(this);
    position_->setAccessibleName(tr("Time in the session"));
    connect(position_, &QLineEdit::returnPressed, this, &ReviewPlayerBar::goToEntered);
    row.addWidget(position_);
    of_ = new PlainLabel(this);
    setTone(*of_, Tone::Muted);
    row.addWidget(of_);
}

void ReviewPlayerBar::addTool(QWidget* tool)
{
    row_->addWidget(tool, 1);
}

QSize ReviewPlayerBar::minimumSizeHint() const
{
    const int spare = of_->isHidden() ? 0 : of_->sizeHint().width() + row_->spacing();
    return QWidget::minimumSizeHint() - QSize(spare, 0);
}

/// Shows the end time and the clock if they fit.
void ReviewPlayerBar::showClock()
{
    const int margins = layout()->contentsMargins().left() + layout()->contentsMargins().right();
    const int own = of_->isHidden() ? of_->sizeHint().width() + row_->spacing() : 0;
    of_->setVisible(row_->minimumSize().width() + own + margins <= width());
}

void ReviewPlayerBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    showClock();
}

void ReviewPlayerBar::setTimeline(const Timeline& timeline)
{
    lanes_ = timeline;
    timeline_->setTimeline(lanes_);
}

void ReviewPlayerBar::addGrowth()
{
    player_.setRange(secondsOf(session_.begin()), secondsOf(session_.end()));
    if (player_.following()) player_.seek(player_.end());
    emit moved();
    showPlayer();
}

void ReviewPlayerBar::advance(double elapsed)
{
    const double before = player_.position();
    player_.advance(elapsed);
    if (player_.position() != before) emit moved();
    showPlayer();
}

void ReviewPlayerBar::showPlayer()
{
    const double now = player_.position();
    timeline_->setPlayhead(now);
    timeline_->setCursors(player_.a(), player_.b());
    const bool atBegin = now <= player_.begin(), atEnd = now >= player_.end();
    if (!position_->hasFocus()) position_->setText(timeText(now));
    const QString clock =
        wallClock(session_, sessionTimeOf(now)).toString(QStringLiteral("HH:mm:ss 'UTC'"));
    const QString of = tr("of %1 · %2%3")
                           .arg(timeText(player_.end(), 1.0), clock,
                                atEnd     ? QStringLiteral(" · ") + tr("END")
                                : atBegin ? QStringLiteral(" · ") + tr("BEGIN")
                                          : QString());
    if (of_->text() != of) {
        of_->setText(of);
        setTip(*position_, tr("Go to a time (G): seconds, or hours:minutes:seconds")
                               + QLatin1Char('\n') + timeText(now) + QLatin1Char(' ') + of);
        showClock();
    }
    speed_->setText(QString::number(player_.speed(), 'g', 3) + QStringLiteral("×"));
    const bool plays = player_.playing() && !player_.backwards();
    play_->setText(plays ? QStringLiteral("❚❚") : QStringLiteral("▶"));
    play_->setAccessibleName(plays ? tr("Pause") : tr("Play"));
    back_->setText(player_.playing() && player_.backwards() ? QStringLiteral("❚❚")
                                                            : QStringLiteral("◀"));
    loop_->setChecked(player_.loopWanted());
    follow_->setChecked(player_.following());
    follow_->setEnabled(!session_.sealed());
    if (session_.sealed()) setTip(*follow_, tr("The session is closed: it does not grow any more"));
    const bool both = player_.a() && player_.b();
    if (both != difference_->isVisibleTo(this)) difference_->setVisible(both);
}

void ReviewPlayerBar::goTo(double seconds)
{
    player_.seek(seconds);
    if (player_.following() && player_.position() < player_.end()) player_.setFollowing(false);
    emit moved();
    showPlayer();
}

void ReviewPlayerBar::play(bool backwards)
{
    if (player_.playing() && player_.backwards() == backwards) return pause();
    player_.play(backwards);
    emit started();
    emit moved();  // play() may have jumped to the other end
    showPlayer();
}

void ReviewPlayerBar::pause()
{
    player_.pause();
    showPlayer();
}

/// Pauses, and shows `time` if it is given.
void ReviewPlayerBar::pauseAt(std::optional<SessionTime> time)
{
    pause();
    if (time) goTo(secondsOf(*time));
}

void ReviewPlayerBar::stepFrame(bool back)
{
    const SessionTime now = sessionTimeOf(player_.position());
    pauseAt(back ? moments_.frameBefore(now) : moments_.frameAfter(now));
}

void ReviewPlayerBar::stepTo(const QList<double>& times, bool back)
{
    pause();
    const double now = player_.position(), near = 1e-6;
    if (back) {
        const auto after = std::lower_bound(times.begin(), times.end(), now - near);
        if (after != times.begin()) goTo(*std::prev(after));
    } else {
        const auto next = std::upper_bound(times.begin(), times.end(), now + near);
        if (next != times.end()) goTo(*next);
    }
}

void ReviewPlayerBar::stepLane(int lane, bool back)
{
    stepTo(timesOf(lanes_.lanes[lane]), back);
}

/// Returns for each scene the time of its first estimate; the capture time if it has none.
QList<double> ReviewPlayerBar::sceneTimes() const
{
    std::map<std::int64_t, double> times;
    for (const SceneRow& scene : session_.scenes()) times[scene.id] = secondsOf(scene.time);
    std::set<std::int64_t> estimated;
    for (const EstimateRow& row : session_.estimates())
        if (row.role == EstimateRole::First && estimated.insert(row.scene).second)
            times[row.scene] = secondsOf(row.time);
    QList<double> sorted;
    for (const auto& [scene, time] : times) sorted << time;
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

QList<double> ReviewPlayerBar::eventTimes() const
{
    QList<double> times;
    for (const EventRow& event : session_.events()) times << secondsOf(event.time);
    std::sort(times.begin(), times.end());
    return times;
}

void ReviewPlayerBar::speedUp(double factor)
{
    player_.setSpeed(factor * player_.speed());
    showPlayer();
}

void ReviewPlayerBar::setCursor(bool isA)
{
    const double now = player_.position();
    const std::optional<double> before = isA ? player_.a() : player_.b();
    const std::optional<double> after = before == now ? std::nullopt : std::optional(now);
    isA ? player_.setA(after) : player_.setB(after);
    if (player_.a() && player_.b())
        difference_->setText(differenceText(moments_.at(sessionTimeOf(*player_.a())),
                                            moments_.at(sessionTimeOf(*player_.b()))));
    showPlayer();
}

void ReviewPlayerBar::goToEntered()
{
    double seconds = 0.0;
    bool good = true;
    for (const QString& part : position_->text().split(QLatin1Char(':'))) {
        bool isNumber = false;
        seconds = 60.0 * seconds + part.trimmed().toDouble(&isNumber);
        good = good && isNumber;
    }
    emit fieldLeft();
    if (good)
        pauseAt(sessionTimeOf(std::clamp(seconds, player_.begin(), player_.end())));
    else
        showPlayer();
}

void ReviewPlayerBar::addKeys(KeyTable& keys)
{
    addPlayKeys(keys);
    addStepKeys(keys);
}

void ReviewPlayerBar::addPlayKeys(KeyTable& keys)
{
    keys.addGroup(tr("Play"));
    const auto click = [](QPushButton* button) { return [button] { button->click(); }; };
    keys.add({{Qt::Key_Space}, tr("play, pause"), click(play_)});
    keys.add({{Qt::Key_J}, tr("play backwards"), [this] { play(true); }});
    keys.add({{Qt::Key_K}, tr("pause"), [this] { pause(); }});
    keys.add({{Qt::Key_L}, tr("play"), [this] { play(false); }});
    keys.add({{Qt::Key_F}, tr("twice as fast"), [this] { speedUp(2.0); }});
    keys.add({{Qt::Key_H}, tr("half as fast"), [this] { speedUp(0.5); }});
    keys.add({{Qt::Key_A}, tr("cursor A here; again removes it"), [this] { setCursor(true); }});
    keys.add({{Qt::Key_B}, tr("cursor B here; again removes it"), [this] { setCursor(false); }});
    keys.add({{Qt::Key_P}, tr("loop from A to B"), click(loop_)});
    keys.add({{Qt::Key_T}, tr("follow a session that is still recorded"), click(follow_)});
}

void ReviewPlayerBar::addStepKeys(KeyTable& keys)
{
    keys.addGroup(tr("Go"));
    const auto step = [&keys](QKeyCombination key, const QString& meaning,
                              std::function<void()> act) {
        keys.add({.keys = {key}, .meaning = meaning, .pressed = std::move(act), .repeats = true});
    };
    const auto ctrl = [](Qt::Key key) { return QKeyCombination(Qt::CTRL, key); };
    step(Qt::Key_Comma, tr("previous frame"), [this] { stepFrame(true); });
    step(Qt::Key_Period, tr("next frame"), [this] { stepFrame(false); });
    step(ctrl(Qt::Key_Left), tr("a second back"), [this] { goTo(player_.position() - kSecond); });
    step(ctrl(Qt::Key_Right), tr("a second on"), [this] { goTo(player_.position() + kSecond); });
    step(Qt::Key_PageUp, tr("to the previous scene, with its estimate"),
         [this] { stepTo(sceneTimes(), true); });
    step(Qt::Key_PageDown, tr("to the next scene, with its estimate"),
         [this] { stepTo(sceneTimes(), false); });
    step(Qt::Key_Up, tr("to the previous event"), [this] { stepTo(eventTimes(), true); });
    step(Qt::Key_Down, tr("to the next event"), [this] { stepTo(eventTimes(), false); });
    for (int lane = 0; lane < kReviewLanes; ++lane) {
        const auto key = static_cast<Qt::Key>(Qt::Key_1 + lane);
        const QString what = nameOf(static_cast<ReviewLane>(lane)).section(QLatin1Char(' '), 1);
        step(key, tr("to the next: %1 (with Alt: previous)").arg(what),
             [this, lane] { stepLane(lane, false); });
    }
    for (int lane = 0; lane < kReviewLanes; ++lane)
        step(QKeyCombination(Qt::ALT, static_cast<Qt::Key>(Qt::Key_1 + lane)), {},
             [this, lane] { stepLane(lane, true); });
    keys.add({{Qt::Key_Home}, tr("to the beginning"), [this] { goTo(player_.begin()); }});
    keys.add({{Qt::Key_End}, tr("to the end"), [this] { goTo(player_.end()); }});
    keys.add({{Qt::Key_G}, tr("to a time"), [this] {
                  position_->setFocus(Qt::ShortcutFocusReason);
                  position_->selectAll();
              }});
}

}  // namespace terratact
