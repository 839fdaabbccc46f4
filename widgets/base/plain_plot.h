#pragma once

class QwtPlot;

namespace terratact {

/// Prepares a plot for live data. The canvas has no frame and no backing store and is aligned with its scales. Only
/// replot() redraws it, and the plot may shrink and grow freely.
void makePlain(QwtPlot& plot);

}  // namespace terratact
