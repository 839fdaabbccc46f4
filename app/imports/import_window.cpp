#include "app/imports/import_window.h"

#include "app/display/format.h"
#include "app/imports/file_header.h"
#include "app/imports/import_page.h"

namespace terratact {

ImportWindow::ImportWindow(const QString& file, const RobotFile& robot, const QString& folder)
{
    const QString name = format::fileName(file);
    setWindowTitle(tr("IMPORT — %1 — Terratact").arg(name));
    showFileHeader(*header(), tr("IMPORT OF A RECORDING"));
    page_ = new ImportPage(file, robot, folder, this);
    addPage(page_, tr("Import"), Qt::Key_F2, tr("What the recording holds, and its mapping"));
    addHelpTool();
    keyTable().addGroup(tr("Pages"));
    addPageKeys();
    addHelpKeys();
    addRemoteStop();
    connect(page_, &ImportPage::sessionMade, this, &ImportWindow::sessionMade);
}

}  // namespace terratact
