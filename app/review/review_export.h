#pragma once

#include <QString>

namespace terratact {

class NumbersTable;
class TerrainProfileView;
struct ReviewMoment;

// What is shown of a session, as files.  Each returns what stood in its way; empty: the file is there.

/// The terrain's picture; the suffix says which: png, svg, pdf.
QString savePicture(TerrainProfileView& terrain, const QString& path);

/// The numbers of a moment and, where one stood, those of its estimate as CSV.
QString saveNumbers(const ReviewMoment& moment, NumbersTable& estimate, const QString& path);

}  // namespace terratact
