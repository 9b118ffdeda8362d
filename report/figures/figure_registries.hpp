#pragma once

// The registry of figures, in parts by topic. figure_specs() joins them.

#include <span>

#include "report/figures/figures.hpp"

namespace farrier::report {

/// Figures of runs of processes, comparisons, hidden effects, benchmarks, the thesis and faults: figure_registry.cpp.
std::span<const FigureSpec> process_figure_specs() noexcept;

/// Figures of farrier diagnose: diagnosis_registry.cpp.
std::span<const FigureSpec> diagnosis_figure_specs() noexcept;

/// Figures of farrier trial body: body_registry.cpp.
std::span<const FigureSpec> body_figure_specs() noexcept;

}  // namespace farrier::report
