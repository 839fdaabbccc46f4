// The decisions of a person on the scenes: their file, nudges, the export.
#include <QFileInfo>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/imports/truth_page.h"
#include "app/modelling/truth/laser_truth_report.h"
#include "app/shell/file_dialog.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"

namespace terratact {

QString TruthPage::noCellsText()
{
    return tr("This truth file was written by an earlier version and holds no cells of the cloud: "
              "write it again by terratact truth --review to nudge along the way");
}

QString TruthPage::decisionsPath() const
{
    return QString::fromStdString(file_.path()) + QStringLiteral(".decisions.csv");
}

void TruthPage::loadDecisions()
{
    const std::string path = decisionsPath().toStdString();
    if (!QFileInfo::exists(decisionsPath()))
        return showState(tr("Decisions are saved in %1.").arg(format::fileName(decisionsPath())));
    const auto read = readTruthDecisions(path);
    Status fits = read ? checkTruthDecisions(file_.truth(), *read, path) : Status(read.error());
    if (fits) fits = checkCells(*read);
    if (fits) {
        choices_.load(*read);
        rows_->refreshAll();
        return showState(tr("Decisions of %1.").arg(format::fileName(decisionsPath())));
    }
    mayDecide_ = false;
    for (QPushButton* const control : deciding_) control->setEnabled(false);
    showState(tr("%1. Move this file away to start again.").arg(translated(fits.error().message)));
}

Status TruthPage::checkCells(const std::vector<TruthDecision>& decisions) const
{
    for (const TruthDecision& decision : decisions)
        if (decision.cellsAlong() != 0 && !file_.hasCells())
            return fileError(
                decisionsPath().toStdString(),
                Message(TR_NOOP("core", "line %1: along_m moves the cloud, but the truth file was "
                                        "written by an earlier version and does not hold its "
                                        "cells: write it again by terratact truth --review"),
                        decision.line));
    return Done{};
}

void TruthPage::save()
{
    saveSoon_.stop();
    if (isSaved_ || !mayDecide_) return;
    const Status done =
        writeFileAtomically(decisionsPath().toStdString(), truthDecisionsCsv(choices_.decisions()));
    isSaved_ = static_cast<bool>(done);
    showState(done ? tr("Saved in %1.").arg(format::fileName(decisionsPath()))
                   : tr("NOT SAVED: %1").arg(translated(done.error().message)));
}

void TruthPage::decided(bool goesOn)
{
    rows_->refresh(row_);
    isSaved_ = false;
    saveSoon_.start();
    showState(tr("not saved yet"));
    if (const auto next = goesOn ? choices_.nextOpen(row_) : std::nullopt)
        showScene(*next);
    else
        showCurrent();
}

void TruthPage::accept()
{
    if (!mayDecide_) return;
    choices_.accept(row_);
    decided(true);
}

void TruthPage::exclude()
{
    if (!mayDecide_) return;
    choices_.exclude(row_);
    decided(true);
}

void TruthPage::nudge(double offset, double tilt)
{
    if (!mayDecide_) return;
    choices_.nudge(row_, offset, tilt, 0.0);
    decided(false);
}

void TruthPage::nudgeAlong(double along)
{
    if (!mayDecide_) return;
    if (!file_.hasCells()) return showState(noCellsText());
    choices_.nudge(row_, 0.0, 0.0, along);
    decided(false);
}

void TruthPage::moveAhead()
{
    nudgeAlong(kAlongStep);
}

void TruthPage::moveBack()
{
    nudgeAlong(-kAlongStep);
}

void TruthPage::heightUp()
{
    nudge(kHeightStep, 0.0);
}

void TruthPage::heightDown()
{
    nudge(-kHeightStep, 0.0);
}

void TruthPage::tiltUp()
{
    nudge(0.0, kTiltStep);
}

void TruthPage::tiltDown()
{
    nudge(0.0, -kTiltStep);
}

void TruthPage::resetNudge()
{
    if (!mayDecide_) return;
    choices_.removeNudge(row_);
    decided(false);
}

void TruthPage::undo()
{
    const auto row = choices_.undo();
    if (!row) return;
    rows_->refresh(*row);
    row_ = *row;
    decided(false);
    showScene(*row);
}

void TruthPage::askForExport()
{
    const QFileInfo file(QString::fromStdString(file_.path()));
    askForFile(*this,
               {.title = tr("Scenes to write"),
                .start = file.completeBaseName() + tr("_accepted.csv"),
                .filter = tr("Scenes (*.csv)"),
                .kind = FileWish::Kind::ToWrite},
               [this](const QString& path) { exportTo(path); });
}

void TruthPage::exportTo(const QString& path)
{
    save();
    if (QFileInfo::exists(path))
        return showState(tr("%1 exists already: choose another name.").arg(format::fileName(path)));
    LaserTruth decided = file_.truth();
    Status done = applyTruthDecisions(decided, choices_.decisions(), decisionsPath().toStdString(),
                                      [this](std::size_t row) { return file_.grid(row); });
    if (done) done = writeFileAtomically(path.toStdString(), truthScenesCsv(decided));
    showState(done ? tr("%1 known heights written to %2.")
                         .arg(decided.knownHeights())
                         .arg(format::fileName(path))
                   : translated(done.error().message));
}

}  // namespace terratact
