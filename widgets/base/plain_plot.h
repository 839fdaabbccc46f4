#pragma once

class QwtPlot;

namespace terratact {

/// Prepares a plot for what is live: a canvas without a frame that keeps no picture of itself, aligned with its scales;
/// redrawn by replot() alone; and with as much or little room as there is.
void makePlain(QwtPlot& plot);

}  // namespace terratact
