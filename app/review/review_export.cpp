#include "app/review/review_export.h"

#include <qwt_plot_renderer.h>

#include <QApplication>
#include <QFileInfo>
#include <string>
#include <vector>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/review/review_difference.h"
#include "core/store/csv_text.h"
#include "core/store/file_write.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/numbers_table.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

struct ExportWords {
    Q_DECLARE_TR_FUNCTIONS(ReviewExport)
};

QString troubleOf(const Status& status)
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

/// Converts a table with tab-separated columns to CSV.
QString csvOf(const QString& table)
{
    QString csv;
    for (const QString& line : table.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        std::vector<std::string> fields;
        for (const QString& cell : line.split(QLatin1Char('\t')))
            fields.push_back(cell.toStdString());
        csv += QString::fromStdString(csvLine(fields));
    }
    return csv;
}

}  // namespace

QString savePicture(TerrainProfileView& terrain, const QString& path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix != QLatin1String("png") && suffix != QLatin1String("svg")
        && suffix != QLatin1String("pdf"))
        return ExportWords::tr("%1: a picture is a .png, .svg or .pdf").arg(path);
    auto file = NewFile::begin(path.toStdString());
    if (!file) return troubleOf(file.error());
    const QString temporary = QString::fromStdString(file->temporaryPath());
    const AsOnPaper poll(terrain);
    QwtPlotRenderer renderer;
    renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
    constexpr double kWidth = 240.0;  // [mm]
    constexpr int kDotsPerInch = 192;
    const QSizeF shown = terrain.size();
    renderer.renderDocument(&terrain, temporary, suffix,
                            QSizeF(kWidth, kWidth * shown.height() / shown.width()), kDotsPerInch);
    if (QFileInfo(temporary).size() <= 0)
        return ExportWords::tr("%1 could not be written").arg(path);
    return troubleOf(file->commit());
}

QString saveNumbers(const ReviewMoment& moment, NumbersTable& estimate, const QString& path)
{
    QString text = numbersCsv(moment);
    if (moment.estimate) text += QLatin1Char('\n') + csvOf(estimate.text());
    return troubleOf(writeFileAtomically(path.toStdString(), text.toStdString()));
}

}  // namespace terratact
