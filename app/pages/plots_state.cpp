#include "app/pages/plots_state.h"

#include <algorithm>
#include <cmath>

#include "app/plotting/plot_source.h"

namespace terratact {
void PlotsState::setRows(PlotRows rows)
{
    rows_.clear();
    values_.clear();
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (const std::string& key : rows[i]) add(key, std::min(i, rows_.size()));
    chosen_ = rows_.empty() ? -1 : 0;
}

std::vector<std::string> PlotsState::keys() const
{
    std::vector<std::string> all;
    for (const auto& row : rows_)
        for (const std::string& key : row)
            if (std::find(all.begin(), all.end(), key) == all.end()) all.push_back(key);
    return all;
}

bool PlotsState::isFull() const
{
    return keys().size() >= PlotSource::kMaxChosen;
}

bool PlotsState::add(const std::string& key, std::size_t row)
{
    const auto all = keys();
    const bool isNew = std::find(all.begin(), all.end(), key) == all.end();
    if (isNew && isFull()) return false;
    if (row >= rows_.size()) {
        if (rows_.size() >= kMaxRows) return false;
        rows_.push_back({key});
        values_.emplace_back();
        chosen_ = static_cast<int>(rows_.size()) - 1;
        return true;
    }
    auto& its = rows_[row];
    if (std::find(its.begin(), its.end(), key) != its.end()) return true;
    if (its.size() >= kMaxInRow) return false;
    its.push_back(key);
    values_[row].reset();
    return true;
}

void PlotsState::remove(const std::string& key, std::size_t row)
{
    if (row >= rows_.size()) return;
    std::erase(rows_[row], key);
    values_[row].reset();
    if (rows_[row].empty()) removeRow(row);
}

void PlotsState::removeRow(std::size_t row)
{
    if (row >= rows_.size()) return;
    rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(row));
    values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(row));
    chosen_ = std::min(chosen_, static_cast<int>(rows_.size()) - 1);
}

void PlotsState::choose(int row)
{
    chosen_ = std::clamp(row, -1, static_cast<int>(rows_.size()) - 1);
}

void PlotsState::setEnds(double begin, double end)
{
    begin_ = begin;
    end_ = std::max(end, begin + kMinSpan);
    if (!follows_) return;
    const double span = to_ - from_;
    to_ = end_ + 0.02 * span;  // the newest values are not at the very edge
    from_ = to_ - span;
}

/// Keeps a part of the data visible, and the span between its limits.
void PlotsState::clampSpan()
{
    const double longest = std::max(1.2 * (end_ - begin_), 60.0);
    const double span = std::clamp(to_ - from_, kMinSpan, longest);
    const double middle = std::clamp(0.5 * (from_ + to_), begin_ - 0.4 * span, end_ + 0.4 * span);
    from_ = middle - 0.5 * span;
    to_ = middle + 0.5 * span;
}

void PlotsState::follow()
{
    follows_ = true;
    setEnds(begin_, end_);
}

void PlotsState::showAll()
{
    show(begin_, end_);
}

void PlotsState::show(double from, double to)
{
    if (!std::isfinite(from) || !std::isfinite(to) || !(from < to)) return;
    follows_ = false;
    from_ = from;
    to_ = to;
    clampSpan();
}

void PlotsState::zoom(double factor, double at)
{
    if (!std::isfinite(factor) || !(factor > 0.0) || !std::isfinite(at)) return;
    const bool followed = follows_;
    const double still = followed ? end_ : at;
    show(still - (still - from_) / factor, still + (to_ - still) / factor);
    if (followed) follow();
}

void PlotsState::move(double seconds)
{
    show(from_ + seconds, to_ + seconds);
}

void PlotsState::keepInView(double seconds)
{
    const bool wasInView = seen_ >= from_ && seen_ <= to_;
    seen_ = seconds;
    if (!wasInView || (seconds >= from_ && seconds <= to_)) return;
    const double span = to_ - from_;
    const double from = seconds > to_ ? seconds - 0.1 * span : seconds - 0.9 * span;
    show(from, from + span);
}

void PlotsState::setValues(std::size_t row, std::pair<double, double> range)
{
    const bool isRange =
        std::isfinite(range.first) && std::isfinite(range.second) && range.second > range.first;
    if (row < values_.size() && isRange) values_[row] = range;
}

void PlotsState::fitValues()
{
    for (auto& range : values_) range.reset();
}

}  // namespace terratact
