#pragma once

#include <QString>

namespace terratact {

class NumbersTable;
class TerrainProfileView;
struct ReviewMoment;

// Save the displayed content to files. Each returns an error text; empty: the file was written.

/// Saves the terrain's picture in the format of the file suffix: png, svg, pdf.
QString savePicture(TerrainProfileView& terrain, const QString& path);

/// Saves the numbers of a moment as CSV, with those of its estimate if there is one.
QString saveNumbers(const ReviewMoment& moment, NumbersTable& estimate, const QString& path);

}  // namespace terratact
