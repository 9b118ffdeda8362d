#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "thesis/study/study.hpp"

namespace farrier::thesis {

// One file per chapter or group of figures gives its studies here.
std::span<const Study> chapter4_step();            // 4.1
std::span<const Study> chapter4_models();          // 4.2 to 4.5
std::span<const Study> chapter4_points();          // 4.6, 4.7
std::span<const Study> chapter4_loads();           // 4.8 to 4.10, A.2
std::span<const Study> chapter6_inputs();          // 6.1, C.1
std::span<const Study> chapter6_signals();         // 6.2 to 6.5, C.2
std::span<const Study> chapter6_forgetting();      // 6.6, 6.7
std::span<const Study> chapter6_table();           // T6.1
std::span<const Study> chapter7_tracking();        // 7.2, 7.3
std::span<const Study> chapter7_gain_maps();       // 7.4, 7.5, C.3
std::span<const Study> chapter7_load_cycle();      // 7.6 to 7.8
std::span<const Study> chapter7_estimates();       // 7.9, C.4
std::span<const Study> chapter8();                 // 8.9, 8.11
std::span<const Study> chapter9_estimates();       // 9.1 to 9.3
std::span<const Study> chapter9_gates();           // 9.4 to 9.7, G.1, G.2
std::span<const Study> chapter9_weights();         // 9.8, 9.9, G.3, G.4
std::span<const Study> chapter9_gains();           // 9.10, G.5, G.6
std::span<const Study> chapter9_sines();           // 9.11, 9.12, 9.14, G.7, G.8
std::span<const Study> chapter9_steps();           // 9.13, 9.15
std::span<const Study> chapter9_fixed();           // 1.2, 9.16 to 9.18
std::span<const Study> chapter9_ramps();           // G.9, G.10
std::span<const Study> chapter9_identification();  // 9.19 to 9.21
std::span<const Study> chapter9_pressure();        // 9.22, 9.23
std::span<const Study> chapter10();                // 10.2
// Sentences of a section that no figure shows: numbers that begin with S.
std::span<const Study> section4_sensitivity();  // S4.3
std::span<const Study> section5_update();       // S5.3, S10.3
std::span<const Study> section6_sampling();     // S6.3
std::span<const Study> section7_weights();      // S7.2, S8.2
std::span<const Study> appendix_parameters();   // A.1, TA.1, TA.2

/// Every study, in the order of the text: chapters, then appendices, by number within each.
std::vector<Study> all_studies();

/// The study of that number; null for none.
const Study* find_study(std::span<const Study> studies, std::string_view number) noexcept;

/// Numbers a reader may have meant by an unknown one: those of its chapter, or the nearest; at most eight.
std::vector<std::string> near_numbers(std::span<const Study> studies, const std::string& unknown);

}  // namespace farrier::thesis
