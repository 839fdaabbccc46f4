#include "app/review_window.h"

#include <QApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/force_arrays.h"
#include "app/numbers_page.h"
#include "app/open_file.h"
#include "app/probe_proposals.h"
#include "app/review_events_page.h"
#include "app/review_export.h"
#include "app/review_export_dialog.h"
#include "app/review_player_bar.h"
#include "app/review_timeline.h"
#include "app/robot_words.h"
#include "app/terrain_page.h"
#include "app/view_menu.h"
#include "app/what_if_page.h"
#include "core/atem/link_watch.h"
#include "widgets/arming_control.h"
#include "widgets/atem_panel.h"
#include "widgets/drive_pad.h"
#include "widgets/estimate_strip.h"
#include "widgets/event_list.h"
#include "widgets/held_button.h"
#include "widgets/look.h"
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

QString fileName(const SessionReader& session)
{
    return QFileInfo(QString::fromStdString(session.path())).fileName();
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
      moments_(session_, robot_), forces_(session_, robot_),
      surveyor_(session_.path(), robot_, preferences_->current().forceThreshold)
{
    setWindowTitle(tr("REVIEW — %1 — Terratact").arg(fileName(session_)));
    if (auto notes = readNotes(session_.path()))
        notes_ = std::move(*notes);
    else
        trouble_ = words::sentence(notes.error().text);
    buildHeader();
    addPages(std::move(options.models));
    addTools();
    addPlayer();
    connectAll();
    defineKeys();
    loadTimeline();
    player_->timeline()->showAll();
    showMoment();
    sinceLook_.start();
    look_.start(kLook);
    setFocus();
}

ReviewWindow::~ReviewWindow() = default;

void ReviewWindow::buildHeader()
{
    header()->setSource(tr("REVIEW · %1").arg(words::sourceName(session_.start().source)));
    header()->arming()->hide();
    header()->qualityButton()->hide();
    state_ = addStrip(QStringLiteral("reviewStrip"));
    damage_ = addStrip(QStringLiteral("banner"));
    damage_->setVisible(false);
    for (QLabel* const strip : {state_, damage_}) strip->setWordWrap(true);
}

void ReviewWindow::addPages(QStringList models)
{
    terrain_ = new TerrainPage(robot_, this);
    terrain_->arrange(Layout::Review, lookInForce().fontScale);
    terrain_->viewButton()->hide();
    terrain_->atemPanel()->forbidCommands();
    addPage(terrain_, tr("Terrain"), Qt::Key_F2, tr("What the operator saw at this time"));
    numbers_ = new NumbersPage(
        [this] {
            return NumbersSight{moment_.estimate ? &moment_.estimate->estimate : nullptr,
                                tr("No estimate stood at this time"), limit(), verdict(),
                                moment_.measurement
                                    ? std::optional(secondsOf(moment_.time - moment_.measured))
                                    : std::nullopt};
        },
        this);
    addScrolledPage(numbers_, tr("Numbers"), Qt::Key_F3, tr("The scene of this time as a table"));
    events_ = new ReviewEventsPage(session_, this);
    addScrolledPage(events_, tr("Events"), Qt::Key_F4, tr("Everything the session tells of"));
    robotPage_ = new QScrollArea(this);  // large letters may not all find room
    robotPage_->setFrameShape(QFrame::NoFrame);
    robotPage_->setWidgetResizable(true);
    robotPage_->setFocusPolicy(Qt::NoFocus);
    robotPage_->setWidget(new QWidget(robotPage_));
    auto* robot = new QVBoxLayout(robotPage_->widget());
    robot->setContentsMargins(12, 10, 12, 10);
    robot->setSpacing(10);
    addPage(robotPage_, tr("Robot"), Qt::Key_F5, tr("Forces, attitude and the last events"));
    whatIf_ = new WhatIfPage(robot_, std::move(models), this);
    addScrolledPage(whatIf_, tr("What if"), Qt::Key_F6,
                    tr("Estimate the recorded scene with other settings"));
}

void ReviewWindow::addTools()
{
    connect(addTool(tr("Open"), tr("Open another file in a window of its own (Ctrl+O)")),
            &QPushButton::clicked, this, &ReviewWindow::open);
    connect(addTool(tr("Export"),
                    tr("Write what is shown, or what the session holds, to a file (Ctrl+E)")),
            &QPushButton::clicked, this, &ReviewWindow::exportShown);
    addViewTool(*preferences_, tr("at the next start"));
    addHelpTool(demonstration(),
                [this](const QString& path) { openInAnotherWindow(path, {}, notOpened()); });
}

void ReviewWindow::addPlayer()
{
    player_ = new ReviewPlayerBar(session_, moments_, this);
    note_ = new QLineEdit(player_);
    note_->setPlaceholderText(tr("note (M)"));
    note_->setAccessibleName(tr("Note at this time"));
    note_->setToolTip(
        tr("Kept beside the session, in %1; Enter saves it")
            .arg(QFileInfo(QString::fromStdString(notesPath(session_.path()))).fileName()));
    player_->addTool(note_);
    addBelowPages(player_);
}

void ReviewWindow::connectAll()
{
    connect(rail(), &NavigationRail::pageChosen, this, [this] {
        place();
        showMoment();
    });
    connect(terrain_->verdict(), &VerdictStrip::limitChosen, this, [this](double metres) {
        limit_ = metres;
        showMoment();
    });
    connect(header(), &StatusHeader::alarmsRequested, this,
            [this] { rail()->choose(rail()->pageOf(Qt::Key_F4)); });
    connect(events_, &ReviewEventsPage::seekWanted, player_, &ReviewPlayerBar::goTo);
    connect(whatIf_, &WhatIfPage::answered, this, &ReviewWindow::showMoment);
    connect(note_, &QLineEdit::returnPressed, this, &ReviewWindow::takeNote);
    connect(player_, &ReviewPlayerBar::moved, this, &ReviewWindow::showMoment);
    connect(player_, &ReviewPlayerBar::fieldLeft, this, [this] { setFocus(); });
    // What has passed while it stood does not count.
    connect(player_, &ReviewPlayerBar::started, this, [this] { sinceLook_.restart(); });
    connect(preferences_.get(), &PreferenceStore::changed, this, &ReviewWindow::applyPreferences);
    connect(&look_, &QTimer::timeout, this,
            [this] { look(static_cast<double>(sinceLook_.restart()) * 1e-3); });
}

void ReviewWindow::look(double elapsed)
{
    sinceRefresh_ += elapsed;
    sinceGrowth_ += elapsed;
    if (sinceRefresh_ >= kRefresh) {
        sinceRefresh_ = 0.0;
        followSession();
    }
    player_->advance(elapsed);
    if (currentPage() == whatIf_) whatIf_->refresh(0.0);
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
            events_->reload();
            player_->takeGrowth();  // shows the moment: rows have moved
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
    const Timeline timeline = timelineOf(session_, surveyed, notes_);
    damagedPlaces_ = timeline.gaps.size();
    player_->setTimeline(timeline);
    showState();
}

void ReviewWindow::showMoment()
{
    moment_ = moments_.at(sessionTimeOf(player().position()));
    showHeader();
    showTerrain();
    whatIf_->setRecorded(moment_.estimate, moment_.scene, moment_.model);
    events_->setMoment(moment_);
    showEvents();
    if (currentPage() == numbers_) numbers_->refresh(0.0);
    damage_->setVisible(moment_.damage.has_value());
    if (moment_.damage)
        damage_->setText(tr("DAMAGED from %1 to %2, nothing of it is shown: %3")
                             .arg(timeWords(secondsOf(moment_.damage->first)),
                                  timeWords(secondsOf(moment_.damage->last)),
                                  words::sentence(moment_.damage->why)));
}

void ReviewWindow::showHeader()
{
    const bool heard = moment_.measurement.has_value();
    const double age = secondsOf(moment_.time - (heard ? moment_.measured : moment_.linkSince));
    if (moment_.linkAlive && heard)
        header()->setLink(tr("link %1 Hz").arg(words::number(moment_.linesPerSecond, 0)),
                          Tone::Good);
    else if (!moment_.linkAlive && moment_.linkSince > 0)
        header()->setLink(
            QStringLiteral("%1 · %2").arg(
                words::sentence(describe(LinkAccount{.standing = LinkStanding::Lost,
                                                     .alone = moment_.telemetryAlone}))
                    .toUpper(),
                words::age(age)),
            Tone::Bad);
    else
        header()->setLink(tr("no telemetry"), Tone::Doubt);
    if (heard && secondsOf(moment_.time - moment_.measured) <= kStaleAfter)
        header()->setRobot(glance(moment_.measurement->activity),
                           toneOf(moment_.measurement->activity));
    else
        header()->setRobot(tr("robot: --"), Tone::Plain);
    if (moment_.model)
        header()->setModel(tr("model %1").arg(QString::fromStdString(moment_.model->name)),
                           Tone::Plain, QString::fromStdString(moment_.model->details));
    else
        header()->setModel(tr("no model"), Tone::Doubt);
    const auto unseen =
        std::count_if(moment_.alarms.begin(), moment_.alarms.end(),
                      [](const Alarm& alarm) { return alarm.state != AlarmState::Acknowledged; });
    header()->setAlarms(static_cast<int>(unseen), static_cast<int>(moment_.alarms.size()));
}

double ReviewWindow::limit() const
{
    return limit_.value_or(moment_.estimate ? moment_.estimate->stepLimit : kStepLimit);
}

std::optional<Verdict> ReviewWindow::verdict() const
{
    if (!moment_.estimate || !moment_.scene) return std::nullopt;
    const bool heard = moment_.linkAlive && moment_.measurement
                    && secondsOf(moment_.time - moment_.measured) <= kStaleAfter;
    return verdictOf(moment_.estimate->estimate, moment_.scene->measurement,
                     {.heard = heard, .unbroken = moment_.unbroken}, limit());
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
    std::vector<TimedForces> before;
    if (moment_.measurement) {
        sight.measurement = &*moment_.measurement;
        sight.age = secondsOf(moment_.time - moment_.measured);
        forces = ForceArrays(robot_).of(*moment_.measurement, moment_.line, threshold);
        sight.forces = &forces;
        before = forces_.before(moment_.time, threshold);
        sight.forcesBefore = &before;
    }
    if (moment_.scene) {
        sight.scene = &moment_.scene->measurement;
        sight.sceneTruth = &moment_.scene->truth;
        if (!sight.measurement) {
            sight.measurement = sight.scene;
            sight.age = std::numeric_limits<double>::infinity();  // nothing was heard yet
        }
    }
    terrain_->verdict()->setLimit(limit());
    if (row) {
        sight.estimate = &row->estimate;
        sight.estimateSeconds = row->seconds;
        sight.verdict = verdict();
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
    const auto probe = moment_.proposal ? std::optional(moment_.proposal->seconds) : std::nullopt;
    sight.time = phaseTime(moment_.state, now, AtemLimits{}, {.press = {}, .probe = probe});
    std::optional<ProbeProposal> proposal;
    if (moment_.proposal) {
        proposal = proposalOf(*moment_.proposal);
        sight.proposal = &*proposal;
        sight.probeSeconds = moment_.proposal->seconds;
        if (moment_.state.phase == AtemPhase::Probing) sight.probingBin = moment_.proposal->bin;
    }
    if (row && !proposal)
        sight.bestProbe = bestProbe({row->estimate, adviceAt(limit()), robot_,
                                     ProbeProposal{}.seconds, preferences_->current().probes});
    const QString why = tr("A review commands no robot");
    sight.preconditions << Precondition{Precondition::Level::Missing, why};
    sight.driving = sight.preconditions;
    terrain_->setThreshold(threshold);
    terrain_->setSight(sight);
    forbidCommands();
}

const ProbeAdvice& ReviewWindow::adviceAt(double limit)
{
    if (advised_ != moment_.estimate || advice_.stepLimit != limit) {
        advised_ = moment_.estimate;
        advice_ = adviseProbe(advised_->estimate, robot_, limit);
    }
    return advice_;
}

/// Nothing listens to these; the card says why they are not there.
void ReviewWindow::forbidCommands()
{
    ProbeCard* const probe = terrain_->probeCard();
    QList<QPushButton*> buttons{probe->approveButton(), probe->refuseButton()};
    for (std::size_t i = 0; i < ProbeCard::kOthers; ++i) buttons << probe->otherButton(i);
    for (QPushButton* const button : std::as_const(buttons)) {
        button->setEnabled(false);
        button->hide();
    }
}

void ReviewWindow::showState()
{
    QStringList parts{
        fileName(session_),
        tr("recorded %1")
            .arg(wallClock(session_, 0).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss 'UTC'")))};
    parts << (session_.sealed() ? tr("closed and sealed")
              : grows_          ? tr("BEING RECORDED")
                                : tr("NOT SEALED: its program has not closed it"));
    if (damagedPlaces_ > 0) parts << tr("DAMAGED, places: %1").arg(damagedPlaces_);
    if (!surveyedAll_) parts << tr("frames are looked through …");
    if (!trouble_.isEmpty()) parts << trouble_;
    parts << tr("no command can be sent");
    const QString text = parts.join(QStringLiteral(" · "));
    if (state_->text() != text) state_->setText(text);
}

void ReviewWindow::addNote()
{
    player_->pause();
    note_->setFocus(Qt::ShortcutFocusReason);
}

void ReviewWindow::takeNote()
{
    const QString text = note_->text().trimmed();
    if (text.isEmpty()) return;
    std::vector<ReviewNote> notes = notes_;
    notes.push_back({player().position(), text.toStdString()});
    std::stable_sort(notes.begin(), notes.end(),
                     [](const ReviewNote& a, const ReviewNote& b) { return a.time < b.time; });
    const Status saved = writeNotes(session_.path(), notes);
    trouble_ =
        saved ? QString() : tr("NOTE NOT SAVED: %1").arg(words::sentence(saved.error().text));
    if (saved) {
        notes_ = std::move(notes);
        note_->clear();
        setFocus();
    }
    loadTimeline();
}

ExportSight ReviewWindow::exportSight() const
{
    const ReviewPlayer& p = player();
    ExportSight sight{.now = p.position(),
                      .first = timeline()->first(),
                      .last = timeline()->last(),
                      .isCursors = p.a() && p.b(),
                      .begin = p.begin(),
                      .end = p.end(),
                      .scene = moment_.estimate ? moment_.estimate->scene : 0};
    if (sight.isCursors) {
        sight.first = std::min(*p.a(), *p.b());
        sight.last = std::max(*p.a(), *p.b());
    }
    return sight;
}

void ReviewWindow::exportShown()
{
    if (!export_)
        export_ = new ReviewExportDialog(
            {.session = QString::fromStdString(session_.path()),
             .look = [this] { return exportSight(); },
             .savePicture =
                 [this](const QString& path) { return savePicture(*terrain_->terrain(), path); },
             .saveNumbers =
                 [this](const QString& path) {
                     numbers_->refresh(0.0);
                     return saveNumbers(moment_, *numbers_->table(), path);
                 }},
            this);
    export_->ask();
}

void ReviewWindow::open()
{
    player_->pause();
    const QString folder = QFileInfo(QString::fromStdString(session_.path())).absolutePath();
    askAndOpenInAnotherWindow(*this, folder, {}, notOpened());
}

std::function<void(const QString&)> ReviewWindow::notOpened()
{
    return [this](const QString& why) {
        trouble_ = why;
        showState();
    };
}

void ReviewWindow::applyPreferences(const Preferences& before)
{
    const Preferences& now = preferences_->current();
    if (now.theme != before.theme || now.fontScale != before.fontScale)
        setLook(now.theme, now.fontScale);
    showMoment();
}

void ReviewWindow::defineKeys()
{
    KeyTable& keys = keyTable();
    player_->addKeys(keys);
    keys.addGroup(tr("Pages"));
    addPageKeys();
    numbers_->addKeys(keys);
    // Not R and S, which release STOP and drive back in the console's window.
    keys.add({{Qt::Key_E}, tr("estimate the recorded scene again, on the page What if"), [this] {
                  rail()->choose(rail()->pageOf(Qt::Key_F6));
                  whatIf_->estimate();
              }});
    keys.add({{Qt::Key_M}, tr("a note at this time"), [this] { addNote(); }});
    keys.add({{QKeyCombination(Qt::CTRL, Qt::Key_O)}, tr("open another file"), [this] { open(); }});
    keys.add({{QKeyCombination(Qt::CTRL, Qt::Key_E)}, tr("export to a file"), [this] {
                  exportShown();
              }});
    addHelpKeys();
    addRemoteStop();

    keys.addGroup(tr("View"));
    const auto zoom = [this](double factor) {
        return [this, factor] { timeline()->zoom(factor, player().position()); };
    };
    keys.add({{Qt::Key_Z}, tr("timeline closer"), zoom(2.0)});
    keys.add({{Qt::Key_X}, tr("timeline wider"), zoom(0.5)});
    keys.add({{Qt::Key_V}, tr("all of the timeline"), [this] { timeline()->showAll(); }});
    keys.add({{Qt::Key_D}, tr("show some of the draws as thin lines"), [this] {
                  terrain_->terrain()->setDrawsShown(!terrain_->terrain()->drawsShown());
              }});
    addViewKeys(keys, *preferences_);
    keys.add({{Qt::Key_Escape}, tr("back from a field to the keys"), [this] { setFocus(); }});
    keys.add({{Qt::Key_Tab, Qt::Key_Backtab}, tr("to the next control, to the one before"), {}});
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
                        || (event.kind == EventKind::Link && event.subject != kLinkUp);
        const Weight weight = isBad                    ? Weight::Bad
                            : event.subject == "doubt" ? Weight::Doubt
                                                       : Weight::Note;
        list->add(sentenceOf(event), weight, wallClock(session_, event.time).time());
    }
}

void ReviewWindow::arrange()
{
    terrain_->arrange(Layout::Review, lookInForce().fontScale);
    place();
}

void ReviewWindow::place()
{
    note_->setMinimumSize(scaled(90), scaled(kTarget));
    note_->setMaximumWidth(scaled(220));
    constexpr int kHigh = 800, kWide = 1180;  // [px] at 100 %
    const bool isLow = isMeasured() || height() < scaled(kHigh);
    const bool isNarrow = isMeasured() || width() < scaled(kWide);
    auto* robot = qobject_cast<QBoxLayout*>(robotPage_->widget()->layout());
    timeline()->setDense(isLow);
    terrain_->setVerdictBeside(isNarrow ? 290 : 404);
    if (isNarrow)
        robot->insertWidget(0, terrain_->decisions(), 0, Qt::AlignLeft);
    else
        terrain_->placeDecisions();
    terrain_->decisions()->show();
    const bool isApart = isLow || currentPage() == robotPage_;
    if (isApart)
        robot->addWidget(terrain_->lower(), 1);
    else
        terrain_->placeLower();
    terrain_->stackLower(isApart && isNarrow);
    terrain_->lower()->show();
}

void ReviewWindow::resizeEvent(QResizeEvent* event)
{
    ConsoleWindow::resizeEvent(event);
    place();
}

bool ReviewWindow::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::KeyPress && (object == player_->positionEdit() || object == note_)
        && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        setFocus();
        return true;
    }
    return ConsoleWindow::eventFilter(object, event);
}

}  // namespace terratact
