#include "app/review/review_window.h"

#include <QApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/pages/dbc_files.h"
#include "app/pages/numbers_page.h"
#include "app/pages/picture_tools.h"
#include "app/pages/plots_page.h"
#include "app/pages/side_keys.h"
#include "app/pages/terrain_page.h"
#include "app/pages/terrain_picture.h"
#include "app/review/export/review_export_dialog.h"
#include "app/review/review_events_page.h"
#include "app/review/review_signals_page.h"
#include "app/review/review_timeline.h"
#include "app/review/what_if_page.h"
#include "app/runtime/steady_now.h"
#include "app/sessions/open_recording.h"
#include "app/shell/open_file.h"
#include "app/shell/view_menu.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/drive_strip.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

constexpr int kPollPeriod = 50;      // [ms]
constexpr double kRefresh = 0.5;     // [s] polling period of a growing file
constexpr double kStillGrows = 3.0;  // [s] without growth until the session counts as finished

QString fileName(const SessionReader& session)
{
    return format::fileName(QString::fromStdString(session.path()));
}

}  // namespace

ReviewWindow::ReviewWindow(Options options)
    : session_(std::move(options.session)), robot_(std::move(options.robot)),
      preferences_(options.preferences ? std::move(options.preferences)
                                       : std::make_unique<PreferenceStore>()),
      moments_(session_, robot_), viewStates_(session_, robot_),
      indexer_(session_.path(), robot_, preferences_->current().forceThreshold),
      plotted_(session_.path(), robot_, secondsOf(session_.begin()), secondsOf(session_.end()))
{
    setWindowTitle(tr("REVIEW — %1 — Terratact").arg(fileName(session_)));
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
    pollTimer_.start(kPollPeriod);
    setFocus();
}

ReviewWindow::~ReviewWindow()
{
    delete export_;  // cancels its job before the indexer, whose end may take time
}

void ReviewWindow::buildHeader()
{
    header()->setSource(tr("REVIEW · %1").arg(format::sourceName(session_.start().source)));
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
    display_.emplace(session_, ReviewDisplay::Places{*header(), *damage_, *terrain_->events()});
    terrain_->viewButton()->hide();
    terrain_->atemPanel()->forbidCommands();
    addPage(terrain_, tr("Terrain"), Qt::Key_F2, tr("What the operator saw at this time"));
    numbers_ = new NumbersPage(
        [this] {
            return NumbersViewState{moment_.estimate ? &moment_.estimate->estimate : nullptr,
                                    revisionOf(moment_.estimate.get()),
                                    tr("No estimate at this time"),
                                    viewStates_.limit(moment_),
                                    viewStates_.verdict(moment_),
                                    moment_.measurement
                                        ? std::optional(secondsOf(moment_.time - moment_.measured))
                                        : std::nullopt};
        },
        this);
    addScrolledPage(numbers_, tr("Numbers"), Qt::Key_F3, tr("The scene of this time as a table"));
    events_ = new ReviewEventsPage(session_, this);
    addScrolledPage(events_, tr("Events"), Qt::Key_F4, tr("All events of the session"));
    robotPage_ = new QScrollArea(this);  // in large fonts the content scrolls
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
    signals_ = new ReviewSignalsPage(session_, *preferences_, this);
    addScrolledPage(signals_, tr("Signals"), Qt::Key_F7,
                    tr("What other devices had sent: gas sensors, batteries"));
    plots_ = new PlotsPage(plotted_, *preferences_, PlotsPanel::Kind::Review, this);
    connect(signals_->dbc(), &DbcFiles::wereRead, this,
            [this](const DbcReading& reading) { plotted_.describe(reading.book); });
    addScrolledPage(plots_, tr("Plots"), kPlotsKey, tr("Any signal over the session"));
    plots_->dockIn(*this);
}

void ReviewWindow::addTools()
{
    connect(addTool(tr("Open"), tr("Open a file in another window (Ctrl+O)")),
            &QPushButton::clicked, this, &ReviewWindow::open);
    connect(addTool(tr("Export"),
                    tr("Exports the visible part or the whole session to a file (Ctrl+E)")),
            &QPushButton::clicked, this, &ReviewWindow::exportShown);
    addViewTool(*preferences_, tr("at the next start"));
    addHelpTool(demonstrations(),
                [this](const QString& path) { openInAnotherWindow(path, {}, notOpened()); });
}

void ReviewWindow::addPlayer()
{
    player_ = new ReviewPlayerBar(session_, moments_, this);
    note_ = new ReviewNoteField(session_, player(), player_);
    trouble_ = note_->trouble();
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
        viewStates_.setLimit(metres);
        showMoment();
    });
    connect(header(), &StatusHeader::alarmsRequested, this,
            [this] { rail()->choose(rail()->pageOf(Qt::Key_F4)); });
    connect(events_, &ReviewEventsPage::seekWanted, player_, &ReviewPlayerBar::goTo);
    connect(plots_->panel(), &PlotsPanel::seekWanted, player_, &ReviewPlayerBar::goTo);
    connect(terrain_->pictureTools(), &PictureTools::exportWanted, this,
            &ReviewWindow::exportShown);
    connect(whatIf_, &WhatIfPage::answered, this, &ReviewWindow::showMoment);
    connect(note_, &ReviewNoteField::submitted, this, &ReviewWindow::noteTaken);
    connect(player_, &ReviewPlayerBar::moved, this, &ReviewWindow::showMoment);
    connect(player_, &ReviewPlayerBar::fieldLeft, this, [this] { setFocus(); });
    // The time while playback was paused does not count.
    connect(player_, &ReviewPlayerBar::started, this, [this] { sinceLook_.restart(); });
    connect(preferences_.get(), &PreferenceStore::changed, this, &ReviewWindow::applyPreferences);
    connect(&pollTimer_, &QTimer::timeout, this,
            [this] { poll(static_cast<double>(sinceLook_.restart()) * 1e-3); });
}

void ReviewWindow::poll(double elapsed)
{
    sinceRefresh_ += elapsed;
    sinceGrowth_ += elapsed;
    if (sinceRefresh_ >= kRefresh) {
        sinceRefresh_ = 0.0;
        followSession();
    }
    player_->advance(elapsed);
    if (viewStates_.readOn(moment_)) showTerrain();
    if (currentPage() == whatIf_) whatIf_->refresh(0.0);
    if (plots_->panel()->isVisible()) plots_->refresh(steadyNow());
}

/// Reads new rows of the file and new results of the indexer.
void ReviewWindow::followSession()
{
    bool news = false;
    if (!session_.sealed()) {
        const auto more = session_.refresh();
        if (!more) showMoment();  // rows may have moved before the failure
        if (more && *more) {
            news = true;
            sinceGrowth_ = 0.0;
            grows_ = true;
            events_->reload();
            player_->addGrowth();  // redraws the moment, because rows may have moved
        }
    }
    if (sinceGrowth_ > kStillGrows) grows_ = false;
    if (const auto version = indexer_.version(); version != surveyVersion_) {
        surveyVersion_ = version;
        news = true;
    }
    if (news) loadTimeline();
    showState();
}

void ReviewWindow::loadTimeline()
{
    const Surveyed surveyed = indexer_.found();
    surveyedAll_ = surveyed.share >= 1.0;
    const Timeline timeline = timelineOf(session_, surveyed, notes());
    damagedPlaces_ = timeline.gaps.size();
    player_->setTimeline(timeline);
    showState();
}

void ReviewWindow::showMoment()
{
    moment_ = moments_.at(sessionTimeOf(player().position()));
    display_->show(moment_);
    showTerrain();
    whatIf_->setRecorded(moment_.estimate, moment_.scene, moment_.model);
    events_->setMoment(moment_);
    signals_->setTime(moment_.time);
    plots_->panel()->setTime(secondsOf(moment_.time));
    if (currentPage() == numbers_) numbers_->refresh(0.0);
}

void ReviewWindow::showTerrain()
{
    const Preferences& preferences = preferences_->current();
    terrain_->verdict()->setLimit(viewStates_.limit(moment_));
    terrain_->setThreshold(ReviewViewState::threshold(moment_, preferences));
    terrain_->setViewState(viewStates_.terrain(moment_, whatIf_->answer(), preferences));
    forbidCommands();
}

/// Disables all commands; the panel gives the reason.
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
                                : tr("NOT SEALED: the recording program did not close it"));
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

void ReviewWindow::noteTaken()
{
    trouble_ = note_->trouble();
    if (trouble_.isEmpty()) setFocus();
    loadTimeline();
}

void ReviewWindow::open()
{
    player_->pause();
    const QString folder = QFileInfo(QString::fromStdString(session_.path())).absolutePath();
    openRecording(*this, {.folder = folder, .store = preferences_.get()}, {}, notOpened());
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
    plots_->addKeys(keys);
    // R and S are not used, because they release STOP and drive back in the console.
    keys.add({{Qt::Key_E}, tr("estimate the recorded scene again on the page What if"), [this] {
                  rail()->choose(rail()->pageOf(Qt::Key_F6));
                  whatIf_->estimate();
              }});
    keys.add({{Qt::Key_M}, tr("a note at this time"), [this] { addNote(); }});
    keys.add({{QKeyCombination(Qt::CTRL, Qt::Key_O)}, tr("open another file"), [this] { open(); }});
    keys.add({{QKeyCombination(Qt::CTRL, Qt::Key_E)}, tr("export to a file"), [this] {
                  exportShown();
              }});
    setKeysNote(tr("In the console the same keys send commands. A explores, B asks for a probe, F "
                   "feels forward and drives, M arms, Space approves a probe. Up and Down drive, "
                   "Page Up and Down change the limit. P shows what a command needs, K marks, 1 to "
                   "3 ask for another bin."));
    addHelpKeys();
    addRemoteStop();

    keys.addGroup(tr("View"));
    const auto zoom = [this](double factor) {
        return [this, factor] { timeline()->zoom(factor, player().position()); };
    };
    keys.add({{Qt::Key_Z}, tr("timeline closer"), zoom(2.0)});
    keys.add({{Qt::Key_X}, tr("timeline wider"), zoom(0.5)});
    keys.add({{Qt::Key_V}, tr("all of the timeline"), [this] { timeline()->showAll(); }});
    keys.add({{Qt::Key_D}, tr("show some draws as thin lines"), [this] {
                  terrain_->terrain()->setDrawsShown(!terrain_->terrain()->drawsShown());
              }});
    addSideKeys(keys, *terrain_->terrain(), false);
    terrain_->pictureTools()->addKeys(keys);
    addViewKeys(keys, *preferences_);
    addFullScreenKey();
    keys.add({{Qt::Key_Escape}, tr("back from a field to the keys"), [this] { setFocus(); }});
    keys.add({{Qt::Key_Tab, Qt::Key_Backtab}, tr("to the next control, to the previous one"), {}});
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
    const bool isLow = isFittingFont() || pagesHeight() < scaled(kHigh);
    const bool isNarrow = isFittingFont() || width() < scaled(kWide);
    auto* robot = qobject_cast<QBoxLayout*>(robotPage_->widget()->layout());
    timeline()->setDense(isLow);
    terrain_->setVerdictBeside(isNarrow ? 290 : 404);
    terrain_->driveStrip()->setVisible(!isLow || lookInForce().fontScale <= 100);
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
