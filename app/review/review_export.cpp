#include "app/review/review_export.h"

#include <string>
#include <vector>

#include "app/display/translated.h"
#include "app/review/review_difference.h"
#include "core/store/csv_text.h"
#include "core/store/file_write.h"
#include "widgets/terrain/numbers_table.h"

namespace terratact {
namespace {

QString troubleOf(const Status& status)
{
    return status ? QString() : translated(status.error().message);
}

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

QString saveNumbers(const ReviewMoment& moment, NumbersTable& estimate, const QString& path)
{
    QString text = numbersCsv(moment);
    if (moment.estimate) text += QLatin1Char('\n') + csvOf(estimate.text());
    return troubleOf(writeFileAtomically(path.toStdString(), text.toStdString()));
}

}  // namespace terratact
