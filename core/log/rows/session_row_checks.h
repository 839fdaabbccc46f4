#pragma once

#include <cstdint>
#include <initializer_list>

#include "core/log/rows/session_rows.h"

namespace terratact {

// Rows that SessionWriter refuses. Every function throws std::invalid_argument for such a row.

void requireFinite(std::initializer_list<double> values);
void requireFinite(const SceneRow& row);
void requireFinite(const EstimateRow& row);
void requireFinite(const ProposalRow& row);

/// Requires that both sides have the same settings and the same number of draws. In an estimate of
/// one plane the sides must be equal. The exception names the estimate.
void requireSides(const EstimateRow& row);

/// Requires an id larger than the last one, and makes it the last one.
void requireNext(std::int64_t id, std::int64_t& last);

/// Requires the id of a row that was added. mayBeNone: 0 is allowed and means no row.
void requireKnown(std::int64_t id, std::int64_t last, bool mayBeNone);

}  // namespace terratact
