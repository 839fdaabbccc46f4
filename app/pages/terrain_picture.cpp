#include "app/pages/terrain_picture.h"

#include <qwt_plot_renderer.h>

#include <QApplication>
#include <QFileInfo>
#include <QImage>
#include <memory>
#include <optional>
#include <utility>

#include "app/display/translated.h"
#include "core/store/file_write.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

struct PictureExportWords {
    Q_DECLARE_TR_FUNCTIONS(ReviewExport)
};

constexpr double kWidth = 240.0;       // [mm] of a picture
constexpr double kMillimetres = 25.4;  // of an inch
constexpr int kDotsPerInch = 192;

/// Draws what QwtPlotRenderer::renderDocument() would code as a .png. millimetres: the picture's size.
QImage drawnPixels(const QwtPlotRenderer& renderer, TerrainProfileView& terrain,
                   const QSizeF& millimetres)
{
    QImage pixels((millimetres * (kDotsPerInch / kMillimetres)).toSize(), QImage::Format_ARGB32);
    const int dotsPerMetre = qRound(1000.0 * kDotsPerInch / kMillimetres);
    pixels.setDotsPerMeterX(dotsPerMetre);
    pixels.setDotsPerMeterY(dotsPerMetre);
    pixels.fill(Qt::white);
    renderer.renderTo(&terrain, pixels);
    return pixels;
}

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

std::function<QString()> drawnPicture(TerrainProfileView& terrain, const QString& path,
                                      PictureColours colours)
{
    const auto refused = [](const QString& why) { return [why] { return why; }; };
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix != QLatin1String("png") && suffix != QLatin1String("svg")
        && suffix != QLatin1String("pdf"))
        return refused(PictureExportWords::tr("%1: a picture is a .png, .svg or .pdf").arg(path));
    auto begun = NewFile::begin(path.toStdString());
    if (!begun) return refused(pictureTrouble(begun.error()));
    // Shared, because a std::function copies what it holds.
    const auto file = std::make_shared<NewFile>(*std::move(begun));
    const QString temporary = QString::fromStdString(file->temporaryPath());
    std::optional<AsOnPaper> paper;
    QwtPlotRenderer renderer;
    if (colours == PictureColours::Paper) {
        paper.emplace(terrain);
        renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
    }
    const QSizeF size(kWidth, kWidth * terrain.height() / terrain.width());
    QImage pixels;
    if (suffix == QLatin1String("png"))
        pixels = drawnPixels(renderer, terrain, size);
    else
        renderer.renderDocument(&terrain, temporary, suffix, size, kDotsPerInch);
    return [file, path, temporary, pixels] {
        const bool isCoded = pixels.isNull() || pixels.save(temporary, "PNG");
        if (!isCoded || QFileInfo(temporary).size() <= 0)
            return PictureExportWords::tr("%1 could not be written").arg(path);
        return pictureTrouble(file->commit());
    };
}

QString savePicture(TerrainProfileView& terrain, const QString& path, PictureColours colours)
{
    return drawnPicture(terrain, path, colours)();
}

}  // namespace terratact
