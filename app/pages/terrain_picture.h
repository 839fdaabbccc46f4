#pragma once

#include <QString>
#include <cstdint>

namespace terratact {

class TerrainProfileView;

/// Colours of a saved picture.
enum class PictureColours : std::uint8_t {
    Paper,   ///< of the day theme; the window's colours change for a moment
    AsShown  ///< of the window; nothing in it changes, as a driving console needs
};

/// Saves the terrain's picture in the format of the file suffix: png, svg, pdf. Returns an error text; empty: the file
/// was written.
QString savePicture(TerrainProfileView& terrain, const QString& path,
                    PictureColours colours = PictureColours::Paper);

}  // namespace terratact
