#pragma once

#include <QString>
#include <cstdint>
#include <functional>

namespace terratact {

class TerrainProfileView;

/// Colours of a saved picture.
enum class PictureColours : std::uint8_t {
    Paper,   ///< of the day theme; the window's colours change for a moment
    AsShown  ///< of the window; nothing in it changes, as a driving console needs
};

/// Draws the terrain's picture in the format of the file suffix: png, svg, pdf. Returns the function that writes it, in
/// any thread and once. That function returns an error text; empty: the file was written.
std::function<QString()> drawnPicture(TerrainProfileView& terrain, const QString& path,
                                      PictureColours colours);

/// Draws and writes it at once.
QString savePicture(TerrainProfileView& terrain, const QString& path,
                    PictureColours colours = PictureColours::Paper);

}  // namespace terratact
