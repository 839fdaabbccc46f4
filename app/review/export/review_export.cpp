#include "app/review/export/review_export.h"

#include "app/display/translated.h"
#include "app/pages/table_csv.h"
#include "app/review/export/review_difference.h"
#include "core/store/file_write.h"
#include "widgets/terrain/readings/numbers_table.h"

namespace terratact {
namespace {

QString troubleOf(const Status& status)
{
    return status ? QString() : translated(status.error().message);
}

}  // namespace

QString saveNumbers(const ReviewMoment& moment, NumbersTable& estimate, const QString& path)
{
    QString text = numbersCsv(moment);
    if (moment.estimate) text += QLatin1Char('\n') + csvOfTable(estimate.text());
    return troubleOf(writeFileAtomically(path.toStdString(), text.toStdString()));
}

}  // namespace terratact
