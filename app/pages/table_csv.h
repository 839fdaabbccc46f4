#pragma once

#include <QString>
#include <QStringList>
#include <string>
#include <vector>

#include "core/store/csv_text.h"

namespace terratact {

/// Converts a table with tab-separated columns to CSV.
inline QString csvOfTable(const QString& table)
{
    QString csv;
    for (const QString& line : table.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        std::vector<std::string> fields;
        const QStringList cells = line.split(QLatin1Char('\t'));
        fields.reserve(static_cast<std::size_t>(cells.size()));
        for (const QString& cell : cells) fields.push_back(cell.toStdString());
        csv += QString::fromStdString(csvLine(fields));
    }
    return csv;
}

}  // namespace terratact
