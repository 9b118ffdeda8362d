#pragma once

// Parts that the JSON of all diagnoses shares; the form is in diagnosis_json.hpp.

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "core/result.hpp"
#include "report/diagnosis/diagnosis_result.hpp"

namespace farrier::report {

using Json = nlohmann::ordered_json;

Json json_of(const ShownEffect::Number& number);
Json json_of(const ShownEffect& effect);
Json json_of(const diagnosis::ErrorRatio& error);
Json json_of(std::span<const diagnosis::Finding> findings);

/// Fills "effects", "alternatives" and "not_judged", which are arrays already.
void add_judgement(Json& json, const diagnosis::Judgement& judgement, std::span<const ShownEffect> effects);

/// As a file has it.
std::string text_of(const Json& json);

/// Writes a diagnosis as JSON to `path`; refuses what the disk does not take.
Result<Done> write_diagnosis_text(const std::string& path, const std::string& text);

}  // namespace farrier::report
