// The picture of the terrain in the console's window: its menu, its keys, the second screen, and snapshots.
#include <QAction>
#include <QDateTime>
#include <QImage>
#include <QPixmap>
#include <vector>

#include "app/console/main_window.h"
#include "app/console/past/history_control.h"
#include "app/console/past/second_view.h"
#include "app/console/past/snapshot.h"
#include "app/console/past/strip_export.h"
#include "app/console/profile_menu.h"
#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/session_event_logger.h"
#include "app/pages/numbers_page.h"
#include "app/pages/picture_tools.h"
#include "app/pages/table_csv.h"
#include "app/shell/window_picture.h"
#include "core/store/file_write.h"
#include "widgets/terrain/readings/numbers_table.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

constexpr QKeyCombination kSecondViewKey(Qt::CTRL, Qt::Key_D);

/// Returns the numbers of a moment as CSV: a name and a value per line, in SI units.
std::string momentCsv(const RobotMoment& moment, const QDateTime& utc, const QString& source)
{
    std::vector<std::vector<std::string>> rows{
        {"time_utc", utc.toString(Qt::ISODateWithMs).toStdString()},
        {"source", source.toStdString()}};
    if (moment.latest) {
        const Measurement& m = moment.latest->sample.measurement;
        rows.push_back(
            {"telemetry_age_s", fixed(moment.now - secondsOf(moment.latest->arrived), 3)});
        for (const auto& [name, value] :
             {std::pair("pitch_rad", m.pitch), std::pair("roll_rad", m.roll),
              std::pair("front_left_rad", m.frontLeft), std::pair("front_right_rad", m.frontRight),
              std::pair("rear_left_rad", m.rearLeft), std::pair("rear_right_rad", m.rearRight)})
            rows.push_back({name, fixed(value, 5)});
    }
    std::string csv;
    for (const auto& row : rows) csv += csvLine(row);
    return csv;
}

}  // namespace

void MainWindow::addPictureKeys(KeyTable& keys)
{
    PictureTools* const tools = terrainPage_->pictureTools();
    tools->addKeys(keys);
    connect(tools, &PictureTools::exportWanted, this, [this] {
        askAndSavePicture(*terrain(), *this, [this](const QString& path, const QString& trouble) {
            if (!trouble.isEmpty()) return showWhyNot(verbatim(trouble));
            log({TR_NOOP("terratact::MainWindow", "picture written: %1"), path.toStdString()},
                EventSeverity::Note);
        });
    });
    keys.add({{Qt::Key_C}, tr("save a snapshot: picture and numbers, with a note"), [this] {
                  takeSnapshot();
              }});
    keys.add({{kSecondViewKey},
              tr("open or close a second window with terrain and verdict, view only"),
              [this] { toggleSecondView(); }});
    profileMenu_->addSeparator();
    connect(profileMenu_->addAction(tr("Second window, view only (Ctrl+D)")), &QAction::triggered,
            this, &MainWindow::toggleSecondView);
    connect(profileMenu_->addAction(tr("Snapshot with a note (C)")), &QAction::triggered, this,
            &MainWindow::takeSnapshot);
    addStripExport();
}

void MainWindow::addStripExport()
{
    auto* const strips = new StripExport(*exploration_, robot_, *this);
    connect(profileMenu_->addAction(tr("Export the strip of felt ground …")), &QAction::triggered,
            strips, &StripExport::ask);
    connect(strips, &StripExport::refused, this, &MainWindow::showWhyNot);
    connect(strips, &StripExport::wrote, this,
            [this](const Message& text) { log(text, EventSeverity::Note); });
}

void MainWindow::toggleSecondView()
{
    if (secondView_ && secondView_->isVisible()) return void(secondView_->close());
    if (!secondView_)
        secondView_ = new SecondView(robot_, format::sourceName(source_->name()), *this);
    secondView_->open();
    redraw();
}

void MainWindow::showSecondView(const TerrainViewState& viewState)
{
    if (secondView_ && secondView_->isVisible())
        secondView_->show(viewState, verdict()->limit(),
                          exploration_->options().settings.forceThreshold, linkStatus_->banner());
}

/// Saves the present: numbers of the past in a file could be taken for those of now.
void MainWindow::takeSnapshot()
{
    if (snapshotWriter_ && snapshotWriter_->isWriting())
        return showWhyNot(
            TR_NOOP("terratact::MainWindow", "a snapshot is still being written: try again"));
    history_->showPresent();
    redraw();
    const bool isRecorded = eventLogger_ && recorder_->state().recording;
    const QDateTime utc = QDateTime::currentDateTimeUtc();
    const SnapshotFiles files =
        snapshotFiles(isRecorded ? recorder_->state().path : std::string(), utc);
    std::string numbers = momentCsv(moment_, utc, format::sourceName(source_->name()));
    numbers_->refresh(moment_.now);
    if (const auto verdict = exploration_->estimation().verdict())
        numbers += csvLine({"verdict", describe(*verdict)});
    if (exploration_->estimation().estimate())
        numbers += '\n' + csvOfTable(numbers_->table()->text()).toStdString();
    if (!snapshotWriter_) {
        snapshotWriter_ = new SnapshotWriter(this);
        connect(snapshotWriter_, &SnapshotWriter::wrote, this, &MainWindow::snapshotWritten);
        snapshotNote_ = new SnapshotNote(*this);
        connect(snapshotNote_, &SnapshotNote::noted, this, &MainWindow::noteSnapshot);
    }
    snapshotWriter_->write(files, pictureOf(*this).toImage(), std::move(numbers));
    putBelowHeader(*snapshotNote_);
    snapshotNote_->ask(files, tr("snapshot %1 is being written").arg(files.name()));
}

/// Reports a snapshot once its files are there.
void MainWindow::snapshotWritten(const SnapshotFiles& files, const QString& trouble)
{
    if (!trouble.isEmpty()) {
        const Message failed{TR_NOOP("terratact::MainWindow", "SNAPSHOT NOT SAVED: %1"),
                             verbatim(trouble)};
        showWhyNot(failed);
        return snapshotNote_->setWritten(translated(failed));
    }
    if (isRecording(files)) eventLogger_->snapshot(files.name());
    const Message saved =
        files.session.empty()
            ? Message(TR_NOOP("terratact::MainWindow", "no session records; the snapshot is in %1"),
                      files.picture())
            : Message(TR_NOOP("terratact::MainWindow", "snapshot %1, beside the session"),
                      files.name().toStdString());
    log(saved, EventSeverity::Note);
    const bool isAsking = snapshotNote_->isVisible();  // the dialog shows the text
    if (files.session.empty() || !isAsking) notice_->show(translated(saved), steadyNow());
    snapshotNote_->setWritten(translated(saved));
}

bool MainWindow::isRecording(const SnapshotFiles& files) const
{
    return eventLogger_ && !files.session.empty() && recorder_->state().recording
        && recorder_->state().path == files.session;
}

/// Keeps a note in the session; beside the files of the snapshot, where that session does not record.
void MainWindow::noteSnapshot(const SnapshotFiles& files, const QString& note)
{
    if (isRecording(files)) return eventLogger_->noteSnapshot(files.name(), note);
    const Status done = writeFileAtomically(files.note(), note.toStdString() + '\n');
    if (!done) showWhyNot(done.error().message);
}

}  // namespace terratact
