#include "app/imports/file_header.h"

#include <QCoreApplication>
#include <QPushButton>

#include "widgets/control/arming_control.h"
#include "widgets/control/status_header.h"

namespace terratact {
namespace {

struct FileHeader {
    Q_DECLARE_TR_FUNCTIONS(FileHeader)
};

}  // namespace

void showFileHeader(StatusHeader& header, const QString& source)
{
    header.setSource(source);
    header.setLink(FileHeader::tr("no link: a file"), Tone::Plain);
    header.setRobot(FileHeader::tr("robot: --"), Tone::Plain);
    header.setModel(FileHeader::tr("model: --"), Tone::Plain);
    for (QWidget* const unused : std::initializer_list<QWidget*>{
             header.arming(), header.qualityButton(), header.alarmsButton()})
        unused->hide();
}

}  // namespace terratact
