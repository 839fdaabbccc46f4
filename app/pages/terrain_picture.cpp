#include "app/pages/terrain_picture.h"

#include <qwt_plot_renderer.h>

#include <QApplication>
#include <QFileInfo>
#include <optional>

#include "app/display/translated.h"
#include "core/store/file_write.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

struct PictureExportWords {
    Q_DECLARE_TR_FUNCTIONS(ReviewExport)
};

QString pictureTrouble(const Status& status)
{
    return status ? QString() : translated(status.error().message);
}

/// Switches to the day theme while it exists, because paper is white.
class AsOnPaper {
public:
    explicit AsOnPaper(TerrainProfileView& terrain) : terrain_(terrain), before_(lookInForce())
    {
        poll(ThemeName::Day);
    }
    ~AsOnPaper() { poll(before_.theme); }
    AsOnPaper(const AsOnPaper&) = delete;
    AsOnPaper& operator=(const AsOnPaper&) = delete;

private:
    void poll(ThemeName theme)
    {
        if (before_.theme == ThemeName::Day) return;
        applyLook(*qApp, theme, before_.fontScale);
        terrain_.restyle();
    }

    TerrainProfileView& terrain_;
    LookInForce before_;
};

}  // namespace

QString savePicture(TerrainProfileView& terrain, const QString& path, PictureColours colours)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix != QLatin1String("png") && suffix != QLatin1String("svg")
        && suffix != QLatin1String("pdf"))
        return PictureExportWords::tr("%1: a picture is a .png, .svg or .pdf").arg(path);
    auto file = NewFile::begin(path.toStdString());
    if (!file) return pictureTrouble(file.error());
    const QString temporary = QString::fromStdString(file->temporaryPath());
    std::optional<AsOnPaper> paper;
    QwtPlotRenderer renderer;
    if (colours == PictureColours::Paper) {
        paper.emplace(terrain);
        renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
    }
    constexpr double kWidth = 240.0;  // [mm]
    constexpr int kDotsPerInch = 192;
    const QSizeF shown = terrain.size();
    renderer.renderDocument(&terrain, temporary, suffix,
                            QSizeF(kWidth, kWidth * shown.height() / shown.width()), kDotsPerInch);
    if (QFileInfo(temporary).size() <= 0)
        return PictureExportWords::tr("%1 could not be written").arg(path);
    return pictureTrouble(file->commit());
}

}  // namespace terratact
