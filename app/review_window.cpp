#include "app/review_window.h"

#include <qwt_plot_renderer.h>

#include <QApplication>
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/force_arrays.h"
#include "app/numbers_page.h"
#include "app/open_file.h"
#include "app/review_difference.h"
#include "app/review_events_page.h"
#include "app/robot_words.h"
#include "app/terrain_page.h"
#include "app/view_menu.h"
#include "app/what_if_page.h"
#include "core/file_write.h"
#include "widgets/arming_control.h"
#include "widgets/atem_panel.h"
#include "widgets/drive_pad.h"
#include "widgets/estimate_strip.h"
#include "widgets/event_list.h"
#include "widgets/held_button.h"
#include "widgets/navigation_rail.h"
#include "widgets/numbers_table.h"
#include "widgets/probe_card.h"
#include "widgets/robot_readout.h"
#include "widgets/status_header.h"
#include "widgets/terrain_profile_view.h"
#include "widgets/verdict_strip.h"
#include "widgets/words.h"

namespace terratact {
namespace {

constexpr int kLook = 50;            // [ms]
constexpr double kRefresh = 0.5;     // [s] between two looks at a file that may grow
constexpr double kStillGrows = 3.0;  // [s] after the last growth
constexpr double kSecond = 1.0;      // [s] of a small jump

QString fileName(const SessionReader& session)
{
    return QFileInfo(QString::fromStdString(session.path())).fileName();
}

QString calendar(const SessionReader& session, SessionTime time)
{
    const qint64 ms = (session.start().wallTime + time) / 1'000'000;
    return QDateTime::fromMSecsSinceEpoch(ms, Qt::UTC)
        .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss 'UTC'"));
}

ProbeProposal proposalOf(const ProposalRow& row)
{
    ProbeProposal p{.id = static_cast<quint64>(row.id),
                    .bin = row.bin,
                    .height = row.height,
                    .q10 = row.q10,
                    .q90 = row.q90,
                    .sd = row.sd,
                    .limit = row.limit,
                    .armSd = row.armSd,
                    .seconds = row.seconds,
                    .stepLimit = row.stepLimit,
                    .bitsBefore = row.bitsBefore,
                    .worth = {},
                    .others = {}};
    for (const OfferedBin& offer : row.offers) {
        const ProbeWorth worth{offer.bin, offer.varianceShare, offer.bitsAfter};
        if (offer.bin == row.bin)
            p.worth = worth;
        else
            p.others.push_back(worth);
    }
    return p;
}

}  // namespace

ReviewWindow::ReviewWindow(Options options)
    : session_(std::move(options.session)), robot_(std::move(options.robot)),
      preferences_(options.preferences ? std::move(options.preferences)
                                       : std::make_unique<PreferenceStore>()),
      moments_(session_, robot_),
      surveyor_(session_.path(), robot_, preferences_->current().forceThreshold)
{
    whatIf_ = new WhatIfPage(robot_, std::move(options.models), this);
    setWindowTitle(tr("REVIEW — %1 — Terratact").arg(fileName(session_)));
    if (auto notes = readNotes(session_.path()))
        notes_ = std::move(*notes);
    else
        notesTrouble_ = QString::fromStdString(notes.error().text);
    build();
    defineKeys();
    player_.setRange(secondsOf(session_.begin()), secondsOf(session_.end()));
    player_.seek(secondsOf(session_.begin()));
    loadTimeline();
    timeline_->showAll();
    showMoment();
    qApp->installEventFilter(this);
    connect(preferences_.get(), &PreferenceStore::changed, this, &ReviewWindow::applyPreferences);
    connect(&look_, &QTimer::timeout, this,
            [this] { look(static_cast<double>(sinceLook_.restart()) * 1e-3); });
    sinceLook_.start();
    look_.start(kLook);
    setFocus();
}

ReviewWindow::~ReviewWindow() = default;

void ReviewWindow::build()
{
    setFocusPolicy(Qt::StrongFocus);
    resize(1440, 900);
    setMinimumSize(1200, 680);
    header_ = new StatusHeader(this);
    header_->setSource(tr("REVIEW · %1").arg(QString::fromStdString(session_.start().source)));
    header_->stopButton()->hide();
    header_->arming()->hide();
    header_->qualityButton()->hide();
    state_ = new QLabel(this);
    state_->setObjectName(QStringLiteral("reviewStrip"));
    damage_ = new QLabel(this);
    damage_->setObjectName(QStringLiteral("banner"));
    damage_->setVisible(false);

    rail_ = new NavigationRail(this);
    pages_ = new QStackedWidget(this);
    const auto addPage = [this](QWidget* page, const QString& name, Qt::Key key,
                                const QString& tip) {
        pages_->addWidget(page);
        rail_->addPage(name, key, tip);
    };
    terrain_ = new TerrainPage(robot_, this);
    addPage(terrain_, tr("Terrain"), Qt::Key_F2, tr("What the operator saw at this time"));
    numbers_ = new NumbersPage(
        [this] {
            return NumbersSight{
                moment_.estimate ? &moment_.estimate->estimate : nullptr,
                tr("No estimate stood at this time"),
                limit_.value_or(moment_.estimate ? moment_.estimate->stepLimit : kStepLimit)};
        },
        this);
    addPage(numbers_, tr("Numbers"), Qt::Key_F3, tr("The scene of this time as a table"));
    events_ = new ReviewEventsPage(session_, this);
    addPage(events_, tr("Events"), Qt::Key_F4, tr("Everything the session tells of"));
    robotPage_ = new QWidget(this);
    auto* robot = new QVBoxLayout(robotPage_);
    robot->setContentsMargins(12, 10, 12, 10);
    addPage(robotPage_, tr("Robot"), Qt::Key_F5, tr("Forces, attitude and the last events"));
    addPage(whatIf_, tr("What if"), Qt::Key_F6,
            tr("Estimate the recorded scene with other settings"));
    connect(rail_, &NavigationRail::pageChosen, this, [this](int page) {
        pages_->setCurrentIndex(page);
        placeLower();
        showMoment();
    });
    const auto tool = [this](const QString& text, const QString& tip, auto clicked) {
        auto* button = new QPushButton(text, rail_);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAccessibleName(text);
        button->setToolTip(tip);
        connect(button, &QPushButton::clicked, this, clicked);
        rail_->addTool(button);
    };
    tool(tr("Open"), tr("Open another file in a window of its own (Ctrl+O)"), &ReviewWindow::open);
    tool(tr("Export"), tr("Save the picture or the numbers that are shown (Ctrl+E)"),
         &ReviewWindow::exportShown);
    auto* view = new QPushButton(tr("View"), rail_);
    view->setAccessibleName(view->text());
    view->setToolTip(tr("Layout, colours and size of the letters"));
    view->setMenu(new ViewMenu(*preferences_, view));
    rail_->addTool(view);
    rail_->addTool(header_->helpButton());

    auto* right = new QVBoxLayout;
    right->setSpacing(0);
    right->addWidget(pages_, 1);
    right->addWidget(transport());
    auto* below = new QHBoxLayout;
    below->setSpacing(0);
    below->addWidget(rail_);
    below->addLayout(right, 1);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addWidget(header_);
    all->addWidget(state_);
    all->addWidget(damage_);
    all->addLayout(below, 1);

    terrain_->terrain()->setMinimumHeight(scaled(170));
    terrain_->arrange(Layout::Review, preferences_->current().fontScale);
    terrain_->viewButton()->hide();
    connect(terrain_->verdict(), &VerdictStrip::limitChosen, this, [this](double metres) {
        limit_ = metres;
        showMoment();
    });
    connect(header_, &StatusHeader::helpRequested, this, &ReviewWindow::showHelp);
    connect(header_, &StatusHeader::alarmsRequested, this,
            [this] { rail_->choose(rail_->pageOf(Qt::Key_F4)); });
    connect(events_, &ReviewEventsPage::seekWanted, this, &ReviewWindow::goTo);
    connect(whatIf_, &WhatIfPage::answered, this, &ReviewWindow::showMoment);
}

QPushButton* ReviewWindow::button(QHBoxLayout& row, const QString& text, const QString& name,
                                  const QString& tip, std::function<void()> clicked)
{
    auto* made = new QPushButton(text, this);
    made->setProperty("role", "compact");
    made->setFocusPolicy(Qt::TabFocus);
    made->setAccessibleName(name);
    made->setToolTip(tip);
    made->setMinimumSize(scaled(38), scaled(kTarget));
    connect(made, &QPushButton::clicked, this, std::move(clicked));
    row.addWidget(made);
    return made;
}

QWidget* ReviewWindow::transport()
{
    auto* panel = new QWidget(this);
    timeline_ = new SessionTimeline(panel);
    connect(timeline_, &SessionTimeline::seekWanted, this, &ReviewWindow::goTo);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    button(*row, QStringLiteral("|◀"), tr("To the begin"), tr("To the begin (Home)"),
           [this] { goTo(player_.begin()); });
    button(*row, QStringLiteral("◀·"), tr("Frame back"), tr("One frame back (,)"),
           [this] { pauseAt(moments_.frameBefore(moment_.time)); });
    backButton_ = button(*row, QStringLiteral("◀"), tr("Play backwards"), tr("Play backwards (J)"),
                         [this] { play(true); });
    playButton_ = button(*row, QStringLiteral("▶"), tr("Play"), tr("Play, pause (Space)"), [this] {
        if (player_.playing())
            pauseAt({});
        else
            play(false);
    });
    button(*row, QStringLiteral("·▶"), tr("Frame on"), tr("One frame on (.)"),
           [this] { pauseAt(moments_.frameAfter(moment_.time)); });
    button(*row, QStringLiteral("▶|"), tr("To the end"), tr("To the end (End)"),
           [this] { goTo(player_.end()); });
    row->addSpacing(6);
    button(*row, QStringLiteral("−"), tr("Slower"), tr("Half as fast (S)"), [this] {
        player_.setSpeed(0.5 * player_.speed());
        showPlayer();
    });
    speed_ = new QLabel(panel);
    speed_->setAccessibleName(tr("Speed"));
    speed_->setAlignment(Qt::AlignCenter);
    speed_->setMinimumWidth(scaled(56));
    row->addWidget(speed_);
    button(*row, QStringLiteral("+"), tr("Faster"), tr("Twice as fast (F)"), [this] {
        player_.setSpeed(2.0 * player_.speed());
        showPlayer();
    });
    row->addSpacing(6);
    button(*row, QStringLiteral("A"), tr("Cursor A here"),
           tr("Cursor A here (A); again removes it"), [this] { setCursor(true); });
    button(*row, QStringLiteral("B"), tr("Cursor B here"),
           tr("Cursor B here (B); again removes it"), [this] { setCursor(false); });
    loop_ = button(*row, tr("loop"), tr("Loop between A and B"),
                   tr("Play from A to B again and again (P)"), [this] {
                       player_.setLoop(!player_.loopWanted());
                       showPlayer();
                   });
    loop_->setCheckable(true);
    follow_ = button(*row, tr("follow"), tr("Follow the end"),
                     tr("Stay at the end of a session that is still recorded (T)"), [this] {
                         player_.setFollowing(!player_.following());
                         if (player_.following()) goTo(player_.end());
                         showPlayer();
                     });
    follow_->setCheckable(true);
    row->addSpacing(6);
    position_ = new QLineEdit(panel);
    position_->setAccessibleName(tr("Time in the session"));
    position_->setToolTip(tr("Go to a time (G): seconds, or hours:minutes:seconds"));
    position_->setFixedWidth(scaled(118));
    position_->setMinimumHeight(scaled(kTarget));
    row->addWidget(position_);
    of_ = new QLabel(panel);
    setTone(*of_, Tone::Muted);
    row->addWidget(of_);
    row->addStretch(1);
    note_ = new QLineEdit(panel);
    note_->setPlaceholderText(tr("note (M)"));
    note_->setAccessibleName(tr("Note at this time"));
    note_->setToolTip(
        tr("Kept beside the session, in %1; Enter saves it")
            .arg(QFileInfo(QString::fromStdString(notesPath(session_.path()))).fileName()));
    note_->setMinimumWidth(scaled(90));
    note_->setMaximumWidth(scaled(220));
    note_->setMinimumHeight(scaled(kTarget));
    row->addWidget(note_, 1);
    difference_ = new QLabel(panel);
    difference_->setAccessibleName(tr("From A to B"));
    difference_->setVisible(false);
    connect(position_, &QLineEdit::returnPressed, this, &ReviewWindow::takePosition);
    connect(note_, &QLineEdit::returnPressed, this, &ReviewWindow::takeNote);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(12, 0, 12, 8);
    column->setSpacing(4);
    column->addWidget(difference_);
    column->addWidget(timeline_);
    column->addLayout(row);
    return panel;
}

void ReviewWindow::look(double elapsed)
{
    const double before = player_.position();
    player_.advance(elapsed);
    sinceRefresh_ += elapsed;
    sinceGrowth_ += elapsed;
    if (sinceRefresh_ >= kRefresh) {
        sinceRefresh_ = 0.0;
        followSession();
    }
    if (player_.position() != before)
        showMoment();
    else
        showPlayer();
    if (pages_->currentWidget() == whatIf_) whatIf_->refresh(0.0);
}

/// Takes what the file and its survey have more of.
void ReviewWindow::followSession()
{
    bool news = false;
    if (!session_.sealed()) {
        const auto more = session_.refresh();
        if (!more) showMoment();  // it may have moved rows before it failed
        if (more && *more) {
            news = true;
            sinceGrowth_ = 0.0;
            grows_ = true;
            player_.setRange(secondsOf(session_.begin()), secondsOf(session_.end()));
            if (player_.following()) player_.seek(player_.end());
            events_->reload();
            showMoment();  // rows have moved
        }
    }
    if (sinceGrowth_ > kStillGrows) grows_ = false;
    if (const auto version = surveyor_.version(); version != surveyVersion_) {
        surveyVersion_ = version;
        news = true;
    }
    if (news) loadTimeline();
    showState();
}

void ReviewWindow::loadTimeline()
{
    const Surveyed surveyed = surveyor_.found();
    surveyedAll_ = surveyed.share >= 1.0;
    lanes_ = timelineOf(session_, surveyed, notes_);
    timeline_->setTimeline(lanes_);
    showState();
}

void ReviewWindow::goTo(double seconds)
{
    player_.seek(seconds);
    if (player_.following() && player_.position() < player_.end()) player_.setFollowing(false);
    showMoment();
}

void ReviewWindow::showMoment()
{
    moment_ = moments_.at(sessionTimeOf(player_.position()));
    showHeader();
    showTerrain();
    whatIf_->setRecorded(moment_.estimate, moment_.scene, moment_.model);
    events_->setMoment(moment_);
    showEvents();
    if (pages_->currentWidget() == numbers_) numbers_->refresh(0.0);
    damage_->setVisible(moment_.damage.has_value());
    if (moment_.damage)
        damage_->setText(tr("DAMAGED from %1 to %2, nothing of it is shown: %3")
                             .arg(timeWords(secondsOf(moment_.damage->first)),
                                  timeWords(secondsOf(moment_.damage->last)),
                                  QString::fromStdString(moment_.damage->why)));
    showPlayer();
}

void ReviewWindow::showHeader()
{
    const bool heard = moment_.measurement.has_value();
    const double age = secondsOf(moment_.time - (heard ? moment_.measured : moment_.linkSince));
    if (moment_.linkAlive && heard)
        header_->setLink(tr("link %1 Hz").arg(words::number(moment_.linesPerSecond, 0)),
                         Tone::Good);
    else if (!moment_.linkAlive && moment_.linkSince > 0)
        header_->setLink(tr("LINK LOST · %1").arg(words::age(age)), Tone::Bad);
    else
        header_->setLink(tr("no telemetry"), Tone::Doubt);
    if (heard && secondsOf(moment_.time - moment_.measured) <= kStaleAfter)
        header_->setRobot(glance(moment_.measurement->activity),
                          toneOf(moment_.measurement->activity));
    else
        header_->setRobot(tr("robot: --"), Tone::Plain);
    if (moment_.model)
        header_->setModel(tr("model %1").arg(QString::fromStdString(moment_.model->name)),
                          Tone::Plain, QString::fromStdString(moment_.model->details));
    else
        header_->setModel(tr("no model"), Tone::Doubt);
    const auto unseen =
        std::count_if(moment_.alarms.begin(), moment_.alarms.end(),
                      [](const Alarm& alarm) { return alarm.state != AlarmState::Acknowledged; });
    header_->setAlarms(static_cast<int>(unseen), static_cast<int>(moment_.alarms.size()));
}

void ReviewWindow::showTerrain()
{
    const EstimateRow* const row = moment_.estimate.get();
    const double now = secondsOf(moment_.time);
    const double threshold =
        row ? row->estimate.settings.forceThreshold : preferences_->current().forceThreshold;
    TerrainSight sight{.now = now};
    sight.count = ++shows_;  // every moment is drawn anew
    std::vector<ForceArray> forces;
    if (moment_.measurement) {
        sight.measurement = &*moment_.measurement;
        sight.age = secondsOf(moment_.time - moment_.measured);
        forces = ForceArrays(robot_).of(*moment_.measurement, moment_.line, threshold);
        sight.forces = &forces;
    }
    if (moment_.scene) {
        sight.scene = &moment_.scene->measurement;
        sight.sceneTruth = &moment_.scene->truth;
        if (!sight.measurement) sight.measurement = sight.scene, sight.age = 1e6;
    }
    const double limit = limit_.value_or(row ? row->stepLimit : kStepLimit);
    terrain_->verdict()->setLimit(limit);
    if (row) {
        sight.estimate = &row->estimate;
        sight.estimateSeconds = row->seconds;
        if (moment_.scene)
            sight.verdict =
                verdictOf(row->estimate, moment_.scene->measurement, moment_.linkAlive, limit);
    }
    if (const auto& answer = whatIf_->answer(); answer && row) {
        sight.second = &*answer;
        sight.secondName = tr("what if: %1").arg(words::text(name(answer->settings.method)));
    } else if (moment_.second) {
        sight.second = &moment_.second->estimate;
        sight.secondName = words::text(name(moment_.second->estimate.settings.method));
    }
    sight.whyNoEstimate = moment_.forgotten.empty() ? tr("No estimate stood at this time")
                                                    : words::sentence(moment_.forgotten);
    sight.state = moment_.state;
    sight.secondsInPhase = now - moment_.state.since;
    if (const auto until = deadline(moment_.state, AtemLimits{}))
        sight.timeLeft = std::max(0.0, *until - now);
    std::optional<ProbeProposal> proposal;
    if (moment_.proposal) {
        proposal = proposalOf(*moment_.proposal);
        sight.proposal = &*proposal;
        sight.probeSeconds = moment_.proposal->seconds;
        if (moment_.state.phase == AtemPhase::Probing) sight.probingBin = moment_.proposal->bin;
    }
    const QString why = tr("A review commands no robot");
    sight.preconditions << Precondition{Precondition::Level::Missing, why};
    sight.whyNotDriving = why;
    terrain_->setThreshold(threshold);
    terrain_->setSight(sight);
    forbidCommands();
}

/// Nothing listens to these; the card says why they are not there.
void ReviewWindow::forbidCommands()
{
    AtemPanel* const atem = terrain_->atemPanel();
    ProbeCard* const probe = terrain_->probeCard();
    QList<QPushButton*> buttons{atem->requestButton(),  atem->abortButton(),
                                atem->releaseButton(),  atem->overrideButton(),
                                probe->approveButton(), probe->refuseButton()};
    for (std::size_t i = 0; i < ProbeCard::kOthers; ++i) buttons << probe->otherButton(i);
    for (QPushButton* const button : std::as_const(buttons)) {
        button->setEnabled(false);
        button->hide();
    }
}

void ReviewWindow::showState()
{
    QStringList parts{tr("REVIEW of %1").arg(fileName(session_)),
                      tr("recorded %1").arg(calendar(session_, 0))};
    parts << (session_.sealed() ? tr("closed and sealed")
              : grows_          ? tr("BEING RECORDED")
                                : tr("NOT SEALED: its program has not closed it"));
    const auto damaged = lanes_.gaps.size();
    if (damaged > 0) parts << tr("DAMAGED, places: %1").arg(damaged);
    if (!surveyedAll_) parts << tr("frames are looked through …");
    if (!notesTrouble_.isEmpty()) parts << notesTrouble_;
    parts << tr("no command can be sent");
    const QString text = parts.join(QStringLiteral(" · "));
    if (state_->text() != text) state_->setText(text);
}

void ReviewWindow::showPlayer()
{
    const double now = player_.position();
    timeline_->setPlayhead(now);
    timeline_->setCursors(player_.a(), player_.b());
    const bool atBegin = now <= player_.begin(), atEnd = now >= player_.end();
    if (!position_->hasFocus()) position_->setText(timeWords(now));
    const QString of = tr("of %1 · %2%3")
                           .arg(timeWords(player_.end(), 1.0),
                                calendar(session_, moment_.time).section(QLatin1Char(' '), 1),
                                atEnd     ? QStringLiteral(" · ") + tr("END")
                                : atBegin ? QStringLiteral(" · ") + tr("BEGIN")
                                          : QString());
    if (of_->text() != of) of_->setText(of);
    const double speed = player_.speed();
    speed_->setText(QString::number(speed, 'g', 3) + QStringLiteral("×"));
    const bool plays = player_.playing() && !player_.backwards();
    playButton_->setText(plays ? QStringLiteral("❚❚") : QStringLiteral("▶"));
    playButton_->setAccessibleName(plays ? tr("Pause") : tr("Play"));
    backButton_->setText(player_.playing() && player_.backwards() ? QStringLiteral("❚❚")
                                                                  : QStringLiteral("◀"));
    loop_->setChecked(player_.loopWanted());
    follow_->setChecked(player_.following());
    follow_->setEnabled(!session_.sealed());
    if (session_.sealed()) follow_->setToolTip(tr("The session is closed: nothing more will come"));
    const bool both = player_.a() && player_.b();
    if (both != difference_->isVisibleTo(this)) difference_->setVisible(both);
}

void ReviewWindow::play(bool backwards)
{
    if (player_.playing() && player_.backwards() == backwards) return pauseAt({});
    player_.play(backwards);
    sinceLook_.restart();  // what has passed while it stood does not count
    showMoment();
}

/// Stands still, at a time where there is one.
void ReviewWindow::pauseAt(std::optional<SessionTime> time)
{
    player_.pause();
    if (time)
        goTo(secondsOf(*time));
    else
        showPlayer();
}

void ReviewWindow::stepTo(const QList<double>& times, bool back)
{
    player_.pause();
    const double now = player_.position(), near = 1e-6;
    if (back) {
        const auto after = std::lower_bound(times.begin(), times.end(), now - near);
        if (after != times.begin()) return goTo(*std::prev(after));
    } else {
        const auto next = std::upper_bound(times.begin(), times.end(), now + near);
        if (next != times.end()) return goTo(*next);
    }
    showPlayer();
}

void ReviewWindow::stepLane(int lane, bool back)
{
    stepTo(timesOf(lanes_.lanes[lane]), back);
}

QList<double> ReviewWindow::eventTimes() const
{
    QList<double> times;
    for (const EventRow& event : session_.events()) times << secondsOf(event.time);
    std::sort(times.begin(), times.end());
    return times;
}

void ReviewWindow::setCursor(bool isA)
{
    const double now = player_.position();
    const std::optional<double> before = isA ? player_.a() : player_.b();
    const std::optional<double> after = before == now ? std::nullopt : std::optional(now);
    isA ? player_.setA(after) : player_.setB(after);
    if (player_.a() && player_.b())
        difference_->setText(differenceWords(moments_.at(sessionTimeOf(*player_.a())),
                                             moments_.at(sessionTimeOf(*player_.b()))));
    showPlayer();
}

void ReviewWindow::addNote()
{
    player_.pause();
    note_->setFocus(Qt::ShortcutFocusReason);
    showPlayer();
}

void ReviewWindow::takeNote()
{
    const QString text = note_->text().trimmed();
    if (text.isEmpty()) return;
    std::vector<ReviewNote> notes = notes_;
    notes.push_back({player_.position(), text.toStdString()});
    std::stable_sort(notes.begin(), notes.end(),
                     [](const ReviewNote& a, const ReviewNote& b) { return a.time < b.time; });
    const Status saved = writeNotes(session_.path(), notes);
    notesTrouble_ = saved
                      ? QString()
                      : tr("NOTE NOT SAVED: %1").arg(QString::fromStdString(saved.error().text));
    if (saved) {
        notes_ = std::move(notes);
        note_->clear();
        setFocus();
    }
    loadTimeline();
}

void ReviewWindow::takePosition()
{
    double seconds = 0.0;
    bool good = true;
    for (const QString& part : position_->text().split(QLatin1Char(':'))) {
        bool isNumber = false;
        seconds = 60.0 * seconds + part.trimmed().toDouble(&isNumber);
        good = good && isNumber;
    }
    setFocus();
    if (good)
        pauseAt(sessionTimeOf(std::clamp(seconds, player_.begin(), player_.end())));
    else
        showPlayer();
}

QString ReviewWindow::savePicture(const QString& path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix != QLatin1String("png") && suffix != QLatin1String("svg")
        && suffix != QLatin1String("pdf"))
        return tr("%1: a picture is a .png, .svg or .pdf").arg(path);
    QwtPlotRenderer renderer;
    renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
    constexpr double kWidth = 240.0;  // [mm]
    constexpr int kDotsPerInch = 192;
    const QSizeF shown = terrain_->terrain()->size();
    renderer.renderDocument(terrain_->terrain(), path, suffix,
                            QSizeF(kWidth, kWidth * shown.height() / shown.width()), kDotsPerInch);
    const QFileInfo made(path);
    return made.exists() && made.size() > 0 ? QString() : tr("%1 could not be written").arg(path);
}

QString ReviewWindow::saveNumbers(const QString& path)
{
    QString text = numbersCsv(moment_);
    if (moment_.estimate) {
        numbers_->refresh(0.0);
        text += QLatin1Char('\n')
              + numbers_->table()
                    ->text()
                    .replace(QLatin1Char(','), QLatin1Char(';'))
                    .replace(QLatin1Char('\t'), QLatin1Char(','));
    }
    const Status saved = writeFileAtomically(path.toStdString(), text.toStdString());
    return saved ? QString() : QString::fromStdString(saved.error().text);
}

void ReviewWindow::exportShown()
{
    player_.pause();
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Export what is shown"), {}, tr("Picture (*.png *.svg *.pdf);;Numbers (*.csv)"));
    if (path.isEmpty()) return;
    const bool numbers = path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
    notesTrouble_ = numbers ? saveNumbers(path) : savePicture(path);
    showState();
}

void ReviewWindow::open()
{
    player_.pause();
    const QString why = openInAnotherWindow(this);
    if (why.isEmpty()) return;
    notesTrouble_ = why;
    showState();
}

void ReviewWindow::applyPreferences(const Preferences& before)
{
    const Preferences& now = preferences_->current();
    if (now.theme != before.theme || now.fontScale != before.fontScale)
        applyLook(*qApp, now.theme, now.fontScale);
    terrain_->arrange(Layout::Review, now.fontScale);
    placeLower();
    showMoment();
}

void ReviewWindow::showHelp()
{
    if (!help_) {
        help_ = new QLabel(this, Qt::Tool);
        help_->setWindowTitle(tr("Keys"));
        help_->setTextFormat(Qt::RichText);
        help_->setMargin(18);
    }
    help_->setText(keys_.html());
    help_->resize(help_->sizeHint());
    help_->show();
    help_->raise();
}

void ReviewWindow::definePlayKeys()
{
    keys_.addGroup(tr("Play"));
    const auto click = [](QPushButton* button) { return [button] { button->click(); }; };
    keys_.add({{Qt::Key_Space}, tr("play, pause"), click(playButton_)});
    keys_.add({{Qt::Key_J}, tr("play backwards"), [this] { play(true); }});
    keys_.add({{Qt::Key_K}, tr("pause"), [this] { pauseAt({}); }});
    keys_.add({{Qt::Key_L}, tr("play"), [this] { play(false); }});
    keys_.add({{Qt::Key_F}, tr("twice as fast"), [this] {
                   player_.setSpeed(2.0 * player_.speed());
                   showPlayer();
               }});
    keys_.add({{Qt::Key_S}, tr("half as fast"), [this] {
                   player_.setSpeed(0.5 * player_.speed());
                   showPlayer();
               }});
    keys_.add({{Qt::Key_A}, tr("cursor A here; again removes it"), [this] { setCursor(true); }});
    keys_.add({{Qt::Key_B}, tr("cursor B here; again removes it"), [this] { setCursor(false); }});
    keys_.add({{Qt::Key_P}, tr("loop from A to B"), click(loop_)});
    keys_.add({{Qt::Key_T}, tr("follow a session that is still recorded"), click(follow_)});
}

void ReviewWindow::defineStepKeys()
{
    using Keys = QList<QKeyCombination>;
    keys_.addGroup(tr("Go"));
    const auto step = [this](Keys keys, const QString& meaning, std::function<void()> act) {
        keys_.add({.keys = std::move(keys),
                   .meaning = meaning,
                   .pressed = std::move(act),
                   .repeats = true});
    };
    const auto ctrl = [](Qt::Key key) { return QKeyCombination(Qt::CTRL, key); };
    step({Qt::Key_Comma}, tr("one frame back"),
         [this] { pauseAt(moments_.frameBefore(moment_.time)); });
    step({Qt::Key_Period}, tr("one frame on"),
         [this] { pauseAt(moments_.frameAfter(moment_.time)); });
    step({ctrl(Qt::Key_Left)}, tr("a second back"), [this] { goTo(player_.position() - kSecond); });
    step({ctrl(Qt::Key_Right)}, tr("a second on"), [this] { goTo(player_.position() + kSecond); });
    step({Qt::Key_PageUp}, tr("to the scene before"),
         [this] { stepLane(static_cast<int>(ReviewLane::Scenes), true); });
    step({Qt::Key_PageDown}, tr("to the next scene"),
         [this] { stepLane(static_cast<int>(ReviewLane::Scenes), false); });
    step({Qt::Key_Up}, tr("to the event before"), [this] { stepTo(eventTimes(), true); });
    step({Qt::Key_Down}, tr("to the next event"), [this] { stepTo(eventTimes(), false); });
    for (int lane = 0; lane < kReviewLanes; ++lane) {
        const auto key = static_cast<Qt::Key>(Qt::Key_1 + lane);
        const QString what = nameOf(static_cast<ReviewLane>(lane)).section(QLatin1Char(' '), 1);
        step({key}, tr("to the next of: %1 (with Alt: before)").arg(what),
             [this, lane] { stepLane(lane, false); });
    }
    for (int lane = 0; lane < kReviewLanes; ++lane)
        keys_.add({.keys = {QKeyCombination(Qt::ALT, static_cast<Qt::Key>(Qt::Key_1 + lane))},
                   .meaning = {},
                   .pressed = [this, lane] { stepLane(lane, true); },
                   .repeats = true});
    keys_.add({{Qt::Key_Home}, tr("to the begin"), [this] { goTo(player_.begin()); }});
    keys_.add({{Qt::Key_End}, tr("to the end"), [this] { goTo(player_.end()); }});
    keys_.add({{Qt::Key_G}, tr("to a time"), [this] {
                   position_->setFocus(Qt::ShortcutFocusReason);
                   position_->selectAll();
               }});
}

void ReviewWindow::defineKeys()
{
    definePlayKeys();
    defineStepKeys();
    keys_.addGroup(tr("Pages"));
    for (int page = 0; page < rail_->pages(); ++page)
        keys_.add({{static_cast<Qt::Key>(rail_->keyOf(page))},
                   rail_->button(page)->accessibleName(),
                   [this, page] { rail_->choose(page); }});
    keys_.add({{Qt::Key_R}, tr("estimate the recorded scene again, on the page What if"), [this] {
                   rail_->choose(rail_->pageOf(Qt::Key_F6));
                   whatIf_->estimate();
               }});
    keys_.add({{Qt::Key_M}, tr("a note at this time"), [this] { addNote(); }});
    keys_.add(
        {{QKeyCombination(Qt::CTRL, Qt::Key_O)}, tr("open another file"), [this] { open(); }});
    keys_.add({{QKeyCombination(Qt::CTRL, Qt::Key_E)}, tr("export what is shown"), [this] {
                   exportShown();
               }});
    keys_.add({{Qt::Key_F1, Qt::Key_Question}, tr("this sheet"), [this] { showHelp(); }});

    keys_.addGroup(tr("View"));
    keys_.add(
        {{Qt::Key_Z}, tr("timeline closer"), [this] { timeline_->zoom(2.0, player_.position()); }});
    keys_.add(
        {{Qt::Key_X}, tr("timeline wider"), [this] { timeline_->zoom(0.5, player_.position()); }});
    keys_.add({{Qt::Key_V}, tr("all of the timeline"), [this] { timeline_->showAll(); }});
    keys_.add({{Qt::Key_D}, tr("show some of the draws as thin lines"), [this] {
                   terrain_->terrain()->setDrawsShown(!terrain_->terrain()->drawsShown());
               }});
    for (const ViewChoice& choice : viewChoices())
        if (!choice.keys.isEmpty())
            keys_.add({choice.keys, choice.name,
                       [this, edit = choice.edit] { preferences_->change(edit); }});
    keys_.add({{Qt::Key_Escape}, tr("back from a field to the keys"), [this] { setFocus(); }});
    keys_.add({{Qt::Key_Tab, Qt::Key_Backtab}, tr("to the next control, to the one before"), {}});
}

/// The events up to this time beside the robot, as the operator had them.
void ReviewWindow::showEvents()
{
    constexpr std::size_t kListed = 40;
    std::vector<const EventRow*> last;
    for (const EventRow& event : session_.events())
        if (event.time <= moment_.time && event.kind != EventKind::Session) last.push_back(&event);
    const std::int64_t newest = last.empty() ? 0 : last.back()->id;
    if (newest == listed_) return;
    listed_ = newest;
    EventList* const list = terrain_->events();
    list->clear();
    const std::size_t from = last.size() - std::min(last.size(), kListed);
    for (std::size_t i = from; i < last.size(); ++i) {
        const EventRow& event = *last[i];
        const bool isBad = event.subject == "bad" || event.kind == EventKind::Gap
                        || (event.kind == EventKind::Alarm && event.number == 3.0)
                        || (event.kind == EventKind::Link && event.subject != "up");
        const Weight weight = isBad                    ? Weight::Bad
                            : event.subject == "doubt" ? Weight::Doubt
                                                       : Weight::Note;
        const qint64 ms = (session_.start().wallTime + event.time) / 1'000'000;
        list->add(sentenceOf(event), weight, QDateTime::fromMSecsSinceEpoch(ms, Qt::UTC).time());
    }
}

void ReviewWindow::placeLower()
{
    constexpr int kHigh = 800;  // [px] at 100 %
    QWidget* const lower = terrain_->lower();
    const bool alone = pages_->currentWidget() == robotPage_;
    if (alone || height() < scaled(kHigh))
        robotPage_->layout()->addWidget(lower);
    else
        terrain_->placeLower();
    lower->show();
}

void ReviewWindow::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    placeLower();
}

bool ReviewWindow::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::KeyPress && (object == position_ || object == note_)
        && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        setFocus();
        return true;
    }
    return keys_.filter(*this, *object, *event);
}

}  // namespace terratact
