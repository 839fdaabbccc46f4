// The picture of the terrain in the console's window: its menu, its keys and its file.
#include "app/console/main_window.h"
#include "app/display/translated.h"
#include "app/pages/picture_tools.h"

namespace terratact {

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
}

}  // namespace terratact
