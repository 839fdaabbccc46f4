#include "app/imports/import_window.h"

#include <QLabel>
#include <QPushButton>

#include "app/display/format.h"
#include "app/imports/import_page.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/status_header.h"

namespace terratact {

ImportWindow::ImportWindow(const QString& file, const RobotFile& robot, const QString& folder)
{
    const QString name = format::fileName(file);
    setWindowTitle(tr("IMPORT — %1 — Terratact").arg(name));
    header()->setSource(tr("IMPORT OF A RECORDING"));
    header()->setLink(tr("no link: a file"), Tone::Plain);
    header()->setRobot(tr("robot: --"), Tone::Plain);
    header()->setModel(tr("model: --"), Tone::Plain);
    for (QWidget* const unused : std::initializer_list<QWidget*>{
             header()->arming(), header()->qualityButton(), header()->alarmsButton()})
        unused->hide();
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
