#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace terratact {

/// Rows of plots: the keys of their signals (PlotSignal::key()).
using PlotRows = std::vector<std::vector<std::string>>;

/// What is plotted, over which span and with which cursor. Times are those of the source [s].
class PlotsState {
public:
    static constexpr std::size_t kMaxRows = 6, kMaxInRow = 4;
    static constexpr double kMinSpan = 0.01;  ///< [s]

    // Rows.
    const PlotRows& rows() const { return rows_; }
    void setRows(PlotRows rows);            ///< keeps at most kMaxRows rows of kMaxInRow signals
    std::vector<std::string> keys() const;  ///< every key once
    /// Adds a signal to a row; rows().size(): to a new row. Returns false if there is no room. A row holds each signal
    /// once.
    bool add(const std::string& key, std::size_t row);
    void remove(const std::string& key, std::size_t row);
    void removeRow(std::size_t row);
    int chosen() const { return chosen_; }  ///< row that buttons act on; −1: there is none
    void choose(int row);
    bool isFull() const;  ///< no further signal fits

    // Span.
    /// Sets the ends of the data. While follows(), the span moves with them.
    void setEnds(double begin, double end);
    double from() const { return from_; }
    double to() const { return to_; }
    double begin() const { return begin_; }
    double end() const { return end_; }
    bool follows() const { return follows_; }
    void follow();  ///< shows the newest values
    void showAll();
    void show(double from, double to);
    /// Zooms in by a factor above 1. `at` keeps its place; while follows(), the newest value does.
    void zoom(double factor, double at);
    void move(double seconds);  ///< later if positive

    // Cursor and values.
    std::optional<double> cursor() const { return cursor_; }
    void setCursor(std::optional<double> seconds) { cursor_ = seconds; }
    /// Moves the span so that `seconds` stays visible if the last such time was.
    void keepInView(double seconds);
    const std::optional<std::pair<double, double>>& values(std::size_t row) const
    {
        return values_.at(row);
    }
    void setValues(std::size_t row, std::pair<double, double> range);
    void fitValues();  ///< lets the ranges of all rows follow the visible values

private:
    void clampSpan();

    PlotRows rows_;
    std::vector<std::optional<std::pair<double, double>>> values_;  // of each row
    int chosen_ = -1;
    double begin_ = 0.0, end_ = 1.0;
    double from_ = 0.0, to_ = 30.0;
    bool follows_ = false;
    std::optional<double> cursor_;
    double seen_ = 0.0;  // [s] last time of keepInView()
};

}  // namespace terratact
