#pragma once

#include <QString>

namespace terratact {

class NumbersTable;
struct ReviewMoment;

/// Saves the numbers of a moment as CSV, with those of its estimate if there is one. Returns an error text; empty:
/// the file was written.
QString saveNumbers(const ReviewMoment& moment, NumbersTable& estimate, const QString& path);

}  // namespace terratact
