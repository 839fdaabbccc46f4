#include "app/imports/truth_window.h"

#include <utility>

#include "app/display/format.h"
#include "app/imports/file_header.h"
#include "app/imports/truth_page.h"

namespace terratact {

TruthWindow::TruthWindow(TruthFile file)
{
    const QString name = format::fileName(QString::fromStdString(file.path()));
    setWindowTitle(tr("TRUTH — %1 — Terratact").arg(name));
    showFileHeader(*header(), tr("TRUTH FROM A LASER MAP"));
    page_ = new TruthPage(std::move(file), this);
    addPage(page_, tr("Truth"), Qt::Key_F2, tr("Scenes, their cloud, and the decisions on them"));
    addHelpTool();
    keyTable().addGroup(tr("Pages"));
    addPageKeys();
    page_->addKeys(keyTable());
    addHelpKeys();
    addRemoteStop();
}

}  // namespace terratact
